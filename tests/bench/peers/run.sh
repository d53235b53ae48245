#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
# Other codes beside ours, on equal work, from Debian's packages. Works in build/peers; prints times and ratios.
#   run.sh install                          apt-get the other codes (as root or with sudo)
#   run.sh dem [SCENE [STEPS [CORES]]]      LIGGGHTS, LAMMPS and ours; SCENE: pipe1 pipe10 bed100, default all
#   run.sh coupled [CELLS [UNTIL [CORES]]]  OpenFOAM's DPMFoam and ours; CELLS: 1920 20160, default both
#   run.sh fluid [CORES]                    OpenFOAM's icoFoam: oscillating flow in the same pipe, no particles
#   run.sh accuracy [CASE]                 icoFoam and ours: error against core-seconds; CASE: cavity womersley, default both
#   run.sh cavity [CELLS [STEPS [CORES]]]   icoFoam and ours: a cube under a moving lid, CELLS along each side
# REPEATS=3 takes that many turns, one code after the other, and prints medians.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$(cd "$here/../../.." && pwd)
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1 WM_PROJECT_DIR=/usr/share/openfoam
export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_hwloc_base_binding_policy=none ISAGO_ROOT=$root PYTHONDONTWRITEBYTECODE=1

case ${1:-} in
install)
    ((EUID == 0)) && as_root=() || as_root=(sudo)
    "${as_root[@]}" apt-get -qq update
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o DPkg::Lock::Timeout=600 \
        install --no-install-recommends liggghts lammps openfoam openmpi-bin python3-h5py python3-numpy >/dev/null
    ;;
dem | coupled | fluid | cavity | accuracy)
    mkdir -p "$root/build/peers"
    [[ -f $root/build/release/build.ninja ]] || cmake -S "$root" --preset release >/dev/null
    ninja -C "$root/build/release" dem_bench isago >/dev/null || echo "our own programs do not build: the other codes alone"
    cd "$root/build/peers"
    exec /usr/bin/python3 "$here/$1.py" "${@:2}"
    ;;
*)
    sed -n '4,11s/^# \?//p' "$here/run.sh"
    exit 2
    ;;
esac
