#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Standard streams, several files, in place, reports, help, manual page and completions.
. "$(dirname "$0")/checks.sh"
"$program" colors.xyz out.xyz $few -q

# ---- streams: the format is guessed

check "a pipeline" bash -c "cat colors.xyz | '$program' - - $few 2> /dev/null | cmp - out.xyz"
check "nothing but points in it" bash -c "[ \$('$program' colors.xyz - $few 2> /dev/null | wc -l) = 7 ]"
check "the summary goes elsewhere" bash -c "'$program' - - < colors.xyz 2>&1 > /dev/null | grep -q 'estimated noise'"
for file in "$data/points_3/hippo1.ply" "$data/meshes/mesh_with_colors.off"; do
  check "a stream of ${file##*.}" bash -c "'$program' - - -q < '$file' > stream.out && '$program' '$file' direct.${file##*.} -q && cmp stream.out direct.${file##*.}"
done
check "another format in a stream" bash -c "'$program' - - -q --output-format ply < colors.xyz | head -1 | grep -q ply"
cp colors.xyz colors.dat
check "a format by hand" bash -c "'$program' colors.dat - --format xyz -q $few | cmp - out.xyz"

# ---- in place and several files

cp colors.xyz in_place.xyz
check "in place" "$program" --in-place in_place.xyz -q $few
check "in place, same result" cmp in_place.xyz out.xyz
cp colors.xyz twice.xyz
check "a file as its own output" bash -c "'$program' twice.xyz twice.xyz -q $few && cmp twice.xyz out.xyz"
cp colors.xyz target.xyz && chmod 600 target.xyz && ln -s target.xyz link.xyz
check "in place through a link" "$program" -i link.xyz -q $few
check "the link is still one, with the permissions of its file" bash -c "cmp target.xyz out.xyz && [ -L link.xyz ] && [ \$(stat -c %a target.xyz) = 600 ]"
mkdir first second out
for i in 1 2 3; do cp colors.xyz "first/scan $i.xyz"; done
echo garbage here too > "first/scan 2.xyz"
cp first/* second
check "several files, one of them bad" fails_with 2 'cannot read first/scan 2.xyz: line 1: "garbage" is not a number' \
  "$program" --output-dir out first/*.xyz $few
check "the others are done" bash -c "cmp 'out/scan 1.xyz' out.xyz && cmp 'out/scan 3.xyz' out.xyz && [ \$(ls out | wc -l) = 2 ]"
check "so in place" fails_with 2 "second/scan 2.xyz" "$program" -i second/*.xyz $few -q
check "all are as they should" bash -c "cmp 'second/scan 1.xyz' out.xyz && cmp 'second/scan 2.xyz' 'first/scan 2.xyz' && cmp 'second/scan 3.xyz' out.xyz"
check "with a new extension" bash -c "'$program' -d out 'first/scan 1.xyz' --output-format ply -q && head -1 'out/scan 1.ply' | grep -q ply"
check "nothing else is left" bash -c "! ls */*.part 2> /dev/null"

# ---- no option swallows a file, and no input is written over that was not asked to be replaced

mkdir safe kept && for name in a b c; do cp colors.xyz kept/$name.xyz; done
fresh() { rm -rf safe; cp -r kept safe; mkdir safe/out; } # three files and an empty directory
smoothed() { for f in "$@"; do cmp "$f" out.xyz || return; done; }
for json in --json --js; do
  fresh
  check "$json before files in place" bash -c "cd safe && '$program' --in-place $json a.xyz b.xyz c.xyz $few > report && grep -q '\"input\": \"a.xyz\"' report"
  check "all of them are smoothed" smoothed safe/a.xyz safe/b.xyz safe/c.xyz
  fresh
  check "$json before files for a directory" bash -c "cd safe && '$program' --output-dir out $json *.xyz $few > report"
  check "all of them are in it" smoothed safe/out/a.xyz safe/out/b.xyz safe/out/c.xyz
  check "and as they were beside it" bash -c "for f in a b c; do cmp kept/\$f.xyz safe/\$f.xyz || exit; done"
done
check "--print-man takes no file, either" bash -c "'$program' --print-man kept/a.xyz | grep -q '^.TH BALANCED.*1 \"\"'"

fresh
cd safe
ln -s a.xyz link.xyz; ln b.xyz hard.xyz; ln -s . here; cp a.xyz out/a.xyz; ln -s out/a.xyz of_out.xyz
refuses() { # refuses "what" "part of the message" arguments...
  local what=$1 message=$2
  shift 2
  check "refused: $what" fails_with 1 "$message" "$program" $few "$@"
}
refuses "an input as the report" "the report would be written over the input a.xyz" -i a.xyz b.xyz --json=a.xyz
for name in ./a.xyz link.xyz "$PWD/a.xyz" here/a.xyz out/../a.xyz; do
  refuses "the report $name" "the report would be written over the input a.xyz" a.xyz new.xyz --json=$name
  refuses "the report $name of a dry run" "the report would be written over the input a.xyz" -n a.xyz --json=$name
  refuses "the output $name" "is the input itself: to replace a file, use --in-place" a.xyz $name
  refuses "twice the same in place, $name" "are the same file" -i a.xyz $name
done
refuses "a hard link as the report" "the report would be written over the input b.xyz" b.xyz new.xyz --json=hard.xyz
refuses "a hard link as the output" "hard.xyz is the input itself" b.xyz hard.xyz
refuses "hard links in place" "b.xyz and hard.xyz are the same file" -i b.xyz hard.xyz
refuses "an output as the report" "the report would be written over the output" a.xyz new.xyz --json=./new.xyz
refuses "the output that is another input" "out/a.xyz is the input of_out.xyz" -d out a.xyz of_out.xyz
refuses "a directory that is the one of the inputs" "is the input itself" -d here a.xyz b.xyz
check "refused: the file of standard input as output" bash -c "'$program' - a.xyz $few < a.xyz 2>&1 | grep -q 'a.xyz is the input itself'"
check "refused: the file of standard input as report" bash -c "'$program' - new.xyz --json=a.xyz $few < a.xyz 2>&1 | grep -q 'over the input standard input'"
cd ..
check "nothing was written" bash -c "for f in a b c; do cmp kept/\$f.xyz safe/\$f.xyz || exit; done; cmp kept/a.xyz safe/out/a.xyz && [ ! -e safe/new.xyz ]"

# ---- what it does

kitten=$data/points_3/kitten.xyz
check "one thread is all" bash -c "'$program' '$kitten' a.xyz -q --threads 1 && '$program' '$kitten' b.xyz -q && cmp a.xyz b.xyz"
check "the paper's estimator, by hand" bash -c "'$program' '$kitten' c.xyz -q --curvature covariance --flow curvature --feature-threshold 100 --filter-width 0.4 && ! cmp -s b.xyz c.xyz"
check "a progress bar" bash -c "script -qec \"'$program' '$kitten' s.xyz\" /dev/null | grep -q '100%'"
check "a summary" bash -c "'$program' '$kitten' s.xyz | grep -q 'estimated noise'"
check "quiet" bash -c "[ -z \"\$('$program' '$kitten' s.xyz -q 2>&1)\" ]"

# ---- reports

cp "$kitten" dry.xyz
check "a dry run" bash -c "'$program' --dry-run dry.xyz > dry.txt && cmp dry.xyz '$kitten'"
for line in spacing "estimated noise" neighbors iterations "feature threshold" "filter width"; do
  check "it tells: $line" grep -q "^$line *[0-9]" dry.txt
done
check "a dry run in place" bash -c "'$program' -n --in-place dry.xyz > /dev/null && cmp dry.xyz '$kitten'"
check "a dry run with an output" bash -c "'$program' -n dry.xyz none.xyz > /dev/null && [ ! -e none.xyz ]"
check "JSON for a dry run" bash -c "'$program' -n dry.xyz --json | python3 -m json.tool > /dev/null"
"$program" "$kitten" "first/scan 2.xyz" --output-dir out --json=report.json 2> /dev/null > summary.txt
check "a report beside the summary" grep -q 'mean movement' summary.txt
cat > report.py <<'END'
import json
r = json.load(open("report.json"))
assert r["program"] == "balanced-flow-smooth" and not r["dry_run"], r
good, bad = r["files"]
assert good["status"] == "ok" and good["points"] == 5210 and good["format"] == "xyz", good
assert not good["normals"] and good["columns"] == {"x": 1, "y": 2, "z": 3} and "look like normals" in good["warnings"][0], good
assert 0 <= good["noise"] < good["spacing"] and 0 < good["mean_movement"] < 3 * good["spacing"], good
p = good["parameters"]
assert 12 <= p["neighbors"]["fewest"] <= p["neighbors"]["most"] <= 128 and p["iterations"] == 5, p
assert p["feature_threshold"] > 0 and p["filter_width"] == .6 and p["step_length"] == .75, p
assert bad["status"] == "failed" and "not a number" in bad["message"], bad
END
check "the report" python3 report.py
check "what is reported is what is done" bash -c "
  k=\$(python3 -c \"import json; print(repr(json.load(open('report.json'))['files'][0]['parameters']['feature_threshold']))\")
  '$program' '$kitten' k.xyz -q --feature-threshold \$k --filter-width 0.6 && cmp k.xyz out/kitten.xyz"

# ---- noise by hand, and who moved

plane() { awk -v noise="$1" 'BEGIN { srand(2); for (i = 0; i < 2500; ++i) print i % 50 + rand() / 2, int(i / 50) + rand() / 2, noise * (rand() + rand() + rand() - 1.5) }'; }
plane 0 > plane.xyz
plane 0.12 > faint.xyz # a deviation of .06 spacings
"$program" plane.xyz none.xyz --json=none.json > none.txt
check "a plane stays" cmp <(cut -d' ' -f1-3 plane.xyz) <(cut -d' ' -f1-3 none.xyz)
check "and is told to" grep -q '^moved *0% of the points; 100% ' none.txt
check "no steps are told" bash -c "'$program' plane.xyz none.xyz --iterations 0 | grep -q '^moved *0% of the points; 100% made no step'"
printf '0 0 0\n1 0 0\n' > two.xyz
check "too few neighbors are told" bash -c "'$program' two.xyz none.xyz | grep -q '^moved *0% of the points; 100% have fewer than two neighbors'"
check "a small radius is told" bash -c "'$program' faint.xyz none.xyz --neighbor-radius 0.01 | grep -q '^hint *a larger --neighbor-radius'"
"$program" faint.xyz given.xyz --noise 0.06 --json=given.json > given.txt
check "the given noise is told" grep -q '^given noise *0.06$' given.txt
check "it is removed" bash -c "rms() { awk '{ s += \$3^2 } END { print s }' \"\$1\"; }; awk -v a=\$(rms faint.xyz) -v b=\$(rms given.xyz) 'BEGIN { exit !(b < .4 * a) }'"
"$program" plane.xyz relaxed.xyz --relax=3 > relaxed.txt
check "relaxation is told" grep -q '^relaxation steps *3$' relaxed.txt
check "it moves points within their plane" bash -c "awk '(\$3)^2 > 1e-12 { exit 1 }' relaxed.xyz && ! cmp -s plane.xyz relaxed.xyz"
check "five steps by default" bash -c "'$program' -n plane.xyz --relax | grep -q '^relaxation steps *5$' && '$program' -n plane.xyz --relax --json | grep -q '\"relaxation_steps\": 5'"
check "none if not asked for" bash -c "'$program' -n plane.xyz --json | grep -q '\"relaxation_steps\": 0'"
check "not negative" bash -c "'$program' plane.xyz none.xyz --relax=-1 2>&1 | grep -q -e '--relax must not be negative'"
check "a dry run with it" bash -c "'$program' -n faint.xyz --noise 0.06 --json | grep -q '\"noise\": 0.06'"
cat > moved.py <<'END'
import json
for name in "none", "given":
    f = json.load(open(name + ".json"))["files"][0]
    assert f["moved"] + sum(f["not_moved"].values()) == f["points"] == 2500, f
    assert (f["moved"] == 0) == (name == "none"), f
    assert f["parameters"]["noise"] == (.06 if name == "given" else None), f
assert set(f["not_moved"]) == {"without_noise", "too_few_neighbors", "constrained", "at_rest"}, f
END
check "the report says who moved" python3 moved.py

# a flow without prefilter takes K from the surface itself, as in the library; here K depends on the noise
awk 'BEGIN { srand(1); for (i = 0; i < 2000; ++i) print rand(), rand(), rand() }' > noise.xyz
threshold() { "$program" -n noise.xyz --curvature covariance --flow "$1" | sed -n 's/^feature threshold *//p'; }
check "K suits the flow" bash -c "[ '$(threshold anisotropic)' = '$(threshold curvature)' ] && [ '$(threshold well-posed)' = '$(threshold balanced)' ] && [ '$(threshold anisotropic)' != '$(threshold balanced)' ]"

# ---- help

check "help" bash -c "'$program' --help | grep -q sharpness-angle"
check "version" bash -c "'$program' --version | grep -q '^balanced-flow-smooth [0-9]'"
"$program" --print-man=2000-01-01 > page.1
check "the manual page has all options" bash -c "'$program' --help | grep -o -e '--[a-z-]*' | sort -u | while read option; do grep -qF -- \"\${option//-/\\\\-}\" page.1 || { echo \$option; exit 1; }; done"
command -v man > /dev/null && check "man reads the page" bash -c "man --warnings -l page.1 2>&1 > page.txt | grep . && exit 1; grep -q 'EXIT STATUS' page.txt"
for shell in bash zsh fish; do
  "$program" --print-completion $shell > completion.$shell
  command -v $shell > /dev/null && check "$shell reads its completion" $shell -n completion.$shell
done
check "bash completes options" bash -c ". ./completion.bash; COMP_WORDS=(balanced-flow-smooth --output-f); COMP_CWORD=1; _balanced_flow_smooth; [ \"\${COMPREPLY[*]}\" = --output-format ]"
check "bash completes values" bash -c ". ./completion.bash; COMP_WORDS=(balanced-flow-smooth --flow = b); COMP_CWORD=3; _balanced_flow_smooth; [ \"\${COMPREPLY[*]}\" = balanced ]"
echo "all checks passed"
