# SPDX-License-Identifier: GPL-3.0-or-later
# Others that schedule the blocks: GNU parallel, and Dask with a worker that is killed.
. "$(dirname "$0")/checks.sh"

check "in memory" "$smooth" -q scan.xyz expected.xyz
if command -v parallel > /dev/null; then
  check "plan for GNU parallel" "$blocks" plan -q --block-size 3000 dir scan.xyz
  n=$(number_of_blocks dir)
  check "GNU parallel" bash -c "seq 0 $((n - 1)) | parallel --will-cite -j 2 '$blocks' smooth -q dir"
  check "GNU parallel, join" "$blocks" join -q dir
  check "GNU parallel, the result" cmp dir/smoothed/scan.xyz expected.xyz
else
  echo "GNU parallel is not installed"
fi

for python in python3 /usr/bin/python3 none; do # others than the system's do not see its packages
  $python -c "import distributed" 2> /dev/null && break
done
if [ $python = none ]; then
  echo "Dask is not installed"
  exit 0
fi
export DASK_DISTRIBUTED__ADMIN__TICK__INTERVAL=1s
check "plan for Dask" "$blocks" plan -q --block-size 1000 dask scan.xyz
$python -m distributed.cli.dask_scheduler --host 127.0.0.1 --port 0 --no-dashboard --scheduler-file scheduler.json > scheduler.log 2>&1 &
processes=$!
trap 'kill $processes 2> /dev/null' EXIT
for worker in 1 2; do
  $python -m distributed.cli.dask_worker --scheduler-file scheduler.json --nthreads 1 --no-nanny --no-dashboard \
    --local-directory worker.$worker > worker.$worker.log 2>&1 &
  processes="$processes $!"
done
victim=$! # the second worker
$python "$driver" "$PWD/dask" --scheduler-file scheduler.json --program "$blocks" > driver.log 2>&1 &
driving=$!
for ((i = 0; i < 600; ++i)); do # until it works
  [ "$(ls dask/results | grep -c 'result$')" -ge 3 ] && break
  sleep .1
done
check "there is work left" [ "$(ls dask/results | grep -c 'result$')" -lt "$(number_of_blocks dask)" ]
kill -KILL $victim
wait $driving
status=$?
[ $status = 0 ] || cat driver.log
check "Dask with a worker that is killed" [ $status = 0 ]
check "Dask, the result" cmp dask/smoothed/scan.xyz expected.xyz
