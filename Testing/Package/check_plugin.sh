#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs check_plugin.py where the plugin's package is unpacked:
#
#   sh check_plugin.sh UNPACKED/usr check_plugin.py
#
# ParaView 5.11 looks for its list of plugins beside the program. Debian's ParaView from 5.13 on looks for plugins of
# other packages in a folder of the system: there the unpacked files are laid over /usr, for this process alone.
set -eu
if [ ! -e "$1/share/paraview/plugins" ]; then
  exec "$1/bin/pvpython" "$2" "$1"
fi
unset LD_LIBRARY_PATH # they lie where the system's libraries do
for map_user in "" --map-root-user; do
  # shellcheck disable=SC2086 # one word or none
  if unshare $map_user --mount mount -t overlay overlay -o "lowerdir=$1:/usr" /usr 2> /dev/null; then
    # shellcheck disable=SC2016,SC2086 # expanded there; one word or none
    exec unshare $map_user --mount sh -c \
      'mount -t overlay overlay -o "lowerdir=$1:/usr" /usr && exec pvpython "$2" /usr' sh "$1" "$2"
  fi
done
echo "Skipped: no file system can be laid over /usr here, which has the folder that ParaView looks into."
exit 77
