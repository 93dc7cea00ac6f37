#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Does what README says on a clean Debian, as root and with a network, and prints how long it took:
#
#   bash Testing/debian.sh RELEASE [first] [second] [packages]
#
# RELEASE is 12, 13 or testing. The first command is Examples/run.sh, the second one Testing/run.sh (without
# either: both), packages is Testing/package.sh. Commits are tried, not what is changed since. The clean Debian
# is a folder made by debootstrap below TMPDIR, from the mirror of this system's packages; it goes in the end.
# Where it cannot be made, the script says so and returns 77.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
. "$top/Testing/clean_debian.sh"

usage="usage: bash Testing/debian.sh 12|13|testing [first] [second] [packages]"
case ${1:-} in
  12) suite=bookworm ;;
  13) suite=trixie ;;
  testing) suite=testing ;;
  *) give_up "$usage" ;;
esac
for what in "${@:2}"; do
  case $what in first | second | packages) ;; *) give_up "$usage" ;; esac
done
with_own_mounts "$@"
debian=$1
shift
[ $# -gt 0 ] || set -- first second

printf '\n== Making a clean Debian %s ==\n' "$debian"
begin=$SECONDS
roots=$(mktemp -d "${TMPDIR:-/tmp}/geodesic-debian.XXXXXX")
trap 'remove_clean_debians "$roots"' EXIT
trap 'exit 1' INT TERM
root=$roots/debian
make_clean_debian "$suite" "$root"
mount_clean_debian "$root"
git clone -q --no-hardlinks "$top" "$root/root/geodesic-distance"
summary="Debian $debian made in $((SECONDS - begin)) s"$'\n'

declare -A script=([first]=Examples/run.sh [second]=Testing/run.sh [packages]=Testing/package.sh)
failed=0
for what in "$@"; do
  printf '\n== Debian %s: bash %s ==\n' "$debian" "${script[$what]}"
  begin=$SECONDS
  result=passed
  on_clean_debian "$root" "cd /root/geodesic-distance; exec bash ${script[$what]}" || { result=FAILED; failed=1; }
  summary+="Debian $debian, ${script[$what]}: $result in $((SECONDS - begin)) s"$'\n'
done
printf '\n%s' "$summary"
exit $failed
