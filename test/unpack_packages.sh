#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Unpacks packages of a suite of Debian below a directory, without installing them:
# unpack_packages.sh DIRECTORY SUITE PACKAGE... They come from the mirror of this machine. If
# these are there already, nothing is done.
set -eu
mkdir -p "$1"
cd "$1"
suite=$2
shift 2
packages=$*
[ ! -e unpacked ] || [ "$(cat unpacked)" != "$suite $packages" ] || exit 0

mirror=$(apt-cache policy libcgal-dev | awk '$2 ~ /^https?:/ { print $2; exit }')
mkdir -p lists/partial cache/archives/partial
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > sources.list
set -- -o "Dir::Etc::sourcelist=$PWD/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/lists" \
  -o "Dir::Cache=$PWD/cache" -o APT::Sandbox::User=root
apt-get "$@" -qq update
# shellcheck disable=SC2086
apt-get "$@" -qq download $packages
for package in *.deb; do dpkg -x "$package" .; done
rm -r ./*.deb lists cache
echo "$suite $packages" > unpacked
