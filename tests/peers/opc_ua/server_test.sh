#!/usr/bin/env bash
# npm's node-opcua (fetched) as a client of the OPC UA server of a plant.
#
# usage: server_test.sh SYMPLANT EXAMPLES NODE PACKAGES
#
# PACKAGES is the folder of node-opcua, existing or new. Exit code: 0 passed, 1 a check failed, 2 usage, 77 node-opcua is not
# available.
set -euo pipefail
(($# == 4)) || { echo "usage: $0 SYMPLANT EXAMPLES NODE PACKAGES" >&2; exit 2; }
here=$(dirname "${BASH_SOURCE[0]}")
"$here/../npm_package.sh" "$4" node-opcua@2.186.4 || exit $?
exec "$3" "$here/server_test.mjs" "$1" "$2" "$4"
