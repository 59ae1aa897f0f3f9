#!/usr/bin/env bash
# The list of the body-shop line is what its script writes, and check has nothing but notes to say of it.
# usage: body_shop_list.sh FOLDER SYMPLANT
set -euo pipefail
folder=$1 symplant=$2

awk -f "$folder/list.awk" /dev/null | cmp - "$folder/body-shop.csv"
"$symplant" check --fail-on warning "$folder/body-shop.csv" | tail -n 1
