# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Clean Debian systems in folders, for the scripts of tests (to be sourced, after Examples/packages.sh). Needs root
# and a network.

# Ends the script where it cannot run here: CTest counts it as skipped.
skip()
{
  printf 'Skipped: %s\n' "$@" >&2
  exit 77
}

# Starts the script again where its mounts are its own: no other process sees them, and they go when it ends,
# whatever ends it. Takes the script's arguments.
with_own_mounts()
{
  [ -z "${GEODESIC_OWN_MOUNTS:-}" ] || return 0
  [ "$(id -u)" -eq 0 ] || skip "only root can make a clean Debian."
  (install_missing debootstrap) || skip "debootstrap is missing."
  # shellcheck disable=SC2016 # the shell that is started has the folder
  unshare --mount sh -c 'folder=$(mktemp -d) && mount -t proc proc "$folder" && umount "$folder" && rmdir "$folder"' ||
    skip "file systems cannot be mounted here, as a clean Debian needs them."
  GEODESIC_OWN_MOUNTS=yes exec unshare --mount bash "$0" "$@"
}

# Prints, one a line, those of this system's sources of Debian packages that are a release's.
sources_of()
{
  # shellcheck disable=SC2016 # apt-get fills in the names
  apt-get indextargets --format 'deb $(SITE) $(CODENAME) main' 'Created-By: Packages' 'Origin: Debian' 2> /dev/null |
    grep " $1" | sort -u || true
}

# Makes a clean Debian with git in a folder: a release, the folder.
make_clean_debian()
{
  local suite=$1 root=$2 own mirror
  own=$(sources_of "$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")")
  mirror=$(awk '$3 !~ /-/ { print $2; exit }' <<< "$own")
  [ -n "$mirror" ] || skip "this system does not say where its packages come from: run apt-get update first."

  mkdir -p "$root"
  chmod 755 "$root"
  debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$root" "$mirror" > "$root.log" 2>&1 ||
    { tail -n 5 "$root.log" >&2; skip "debootstrap failed (is there a network?)."; }
  rm "$root.log"
  # The same release comes with the updates that this system has.
  if grep -q " $suite main\$" <<< "$own"; then
    printf '%s\n' "$own" > "$root/etc/apt/sources.list"
  fi
  {
    apt-config dump | grep -iE '^Acquire::(https?::Proxy|Check-Valid-Until|Check-Date)' || true
    echo 'Dpkg::Use-Pty "0";' # there are no terminals
  } > "$root/etc/apt/apt.conf.d/90clean-debian"
  # Nothing has to survive a loss of power: dpkg need not wait for the disk.
  echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
}

# Mounts what programs expect there.
mount_clean_debian()
{
  local root=$1 folder
  mount --bind "$root" "$root" # so that tests there can mount as well
  mount --bind "$root" "$root"
  mount -t proc proc "$root/proc"
  mount -t sysfs sysfs "$root/sys"
  for folder in dev dev/pts; do
    mount --bind "/$folder" "$root/$folder"
  done
  mount -t tmpfs tmpfs "$root/dev/shm"
}

# Runs commands on the clean Debian in a folder: the folder, the commands.
on_clean_debian()
{
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    chroot "$1" bash -euc "$2"
}

# Takes away a folder with clean Debians in folders, and what is mounted in them.
remove_clean_debians()
{
  local mounted
  while read -r mounted; do
    umount "$mounted" || umount -l "$mounted"
  done < <(awk -v below="$1/" 'index($2, below) == 1 { print $2 }' /proc/mounts | tac)
  rm -rf --one-file-system "$1"
}
