#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Does what README says on a clean Debian, as root and with a network, and prints how long it took:
#
#   bash Testing/debian.sh RELEASE [first] [second] [packages]
#
# RELEASE is 12, 13 or testing. The first command is Examples/run.sh, the second one Testing/run.sh (without
# either: both), packages is Testing/package.sh. Commits are tried, not what is changed since. The clean Debian
# is a folder made by debootstrap below TMPDIR, from the mirror of this system's packages; it goes in the end.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"

usage="usage: bash Testing/debian.sh 12|13|testing [first] [second] [packages]"
case ${1:-} in
  12) suite=bookworm ;;
  13) suite=trixie ;;
  testing) suite=testing ;;
  *) give_up "$usage" ;;
esac
debian=$1
shift
[ $# -gt 0 ] || set -- first second
for what in "$@"; do
  case $what in first | second | packages) ;; *) give_up "$usage" ;; esac
done
[ "$(id -u)" -eq 0 ] || give_up "Only root can make a clean Debian."
command -v debootstrap > /dev/null || install_missing debootstrap
command -v debootstrap > /dev/null || give_up "debootstrap is missing (Debian: debootstrap)."

# Where this system's packages come from, and its way through a proxy.
# shellcheck disable=SC2016 # apt-get fills in the names
mirror=$(apt-get indextargets --format '$(SITE) $(CODENAME)' 'Created-By: Packages' 'Origin: Debian' 2> /dev/null |
  awk '$2 !~ /-/ { print $1; exit }' || true)
[ -n "$mirror" ] || give_up "This system does not say where its packages come from: run apt-get update first."
proxy=$(apt-config dump 2> /dev/null | grep -i '^Acquire::https\?::Proxy' || true)

root=$(mktemp -d "${TMPDIR:-/tmp}/geodesic-debian.XXXXXX")
remove_root()
{
  local folder
  for folder in dev/shm dev/pts dev sys proc; do
    ! mountpoint -q "$root/$folder" || umount "$root/$folder" || umount -l "$root/$folder"
  done
  rm -rf --one-file-system "$root"
}
trap remove_root EXIT
trap 'exit 1' INT TERM

printf '\n== Making a clean Debian %s ==\n' "$debian"
chmod 755 "$root"
debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$root" "$mirror" > "$root.log" 2>&1 ||
  { tail -n 5 "$root.log"; give_up "debootstrap failed; its messages are in $root.log."; }
rm "$root.log"
printf '%s\n' "$proxy" 'Dpkg::Use-Pty "0";' > "$root/etc/apt/apt.conf.d/90clean-debian"
echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # nothing has to survive a loss of power
mount -t proc proc "$root/proc"
mount -t sysfs sysfs "$root/sys"
mount --bind /dev "$root/dev"
mount --make-private "$root/dev"
mount --bind /dev/pts "$root/dev/pts"
mount -t tmpfs tmpfs "$root/dev/shm"
git clone -q --no-hardlinks "$top" "$root/root/geodesic-distance"

# Runs one command of README there.
on_clean_debian()
{
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 chroot "$root" \
    bash -euc "cd /root/geodesic-distance; exec bash $1"
}

declare -A script=([first]=Examples/run.sh [second]=Testing/run.sh [packages]=Testing/package.sh)
summary=
failed=0
for what in "$@"; do
  printf '\n== Debian %s: bash %s ==\n' "$debian" "${script[$what]}"
  begin=$SECONDS
  result=passed
  on_clean_debian "${script[$what]}" || { result=FAILED; failed=1; }
  summary+="Debian $debian, ${script[$what]}: $result in $((SECONDS - begin)) s"$'\n'
done
printf '\n%s' "$summary"
exit $failed
