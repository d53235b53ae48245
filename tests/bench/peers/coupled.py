# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""1600 grains in oscillating water: OpenFOAM's DPMFoam and ours on the same grid, grains and drive.

Water is driven by +-33.333 m/s2, reversed every 0.09 s and first after 0.045 s. DPMFoam's contact step follows from its
Young modulus: 1e7 Pa resolved by 12 steps gives about 1.7e-5 s. With 20160 cells the cells are smaller than the large
grains, which DPMFoam's volume fraction does not allow: there it measures time, not physics.
"""
import os
import shutil
import sys

import numpy as np

import foam_pipe as foam
import particles
from measure import REPEATS, number, rate, run, table

STEP, DRIVE, YOUNG = 2.5e-4, 33.333, 1e7  # [s], [m/s2], [Pa]
CONTACT = "alpha 0.2; b 1.5; mu 0.5; cohesionEnergyDensity 0; collisionResolutionSteps 12;"


def injection(diameter):
    return f"""grains{diameter}
        {{
            type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0;
            positionsFile "places{diameter}"; U0 (0 0 0);
            sizeDistribution {{ type fixedValue; fixedValueDistribution {{ value {diameter}e-3; }} }}
        }}"""


def cloud(case):
    rows = np.loadtxt("pipe1.txt")
    for diameter in (2, 3):
        places = rows[np.isclose(rows[:, 3], diameter / 2e3), :3]
        text = "\n".join("({:.9g} {:.9g} {:.9g})".format(*place) for place in places)
        foam.write(case, f"constant/places{diameter}", "vectorField", f"(\n{text}\n)")
    foam.write(case, "constant/kinematicCloudProperties", "dictionary", f"""solution
{{
    active true; coupled true; transient yes; cellValueSourceCorrection off;
    interpolationSchemes {{ rho.water cell; U.water cellPoint; mu.water cell; }}
    integrationSchemes {{ U Euler; }}
    sourceTerms {{ schemes {{ U semiImplicit 1; }} }}
}}
constantProperties
{{
    parcelTypeId 1; rhoMin 1e-15; minParcelMass 1e-15; rho0 {particles.DENSITY}; youngsModulus {YOUNG}; poissonsRatio 0.35;
    constantVolume false; alphaMax 0.65;
}}
subModels
{{
    particleForces {{ ErgunWenYuDrag {{ alphac alpha.water; }} gravity; }}
    injectionModels
    {{
        {injection(2)}
        {injection(3)}
    }}
    dispersionModel none; heatTransferModel none; surfaceFilmModel none; stochasticCollisionModel none; radiation off;
    patchInteractionModel localInteraction;
    localInteractionCoeffs
    {{
        patches ( wall {{ type rebound; e 0.6; mu 0.5; }} inlet {{ type none; }} outlet {{ type none; }} );
    }}
    collisionModel pairCollision;
    pairCollisionCoeffs
    {{
        maxInteractionDistance 0.003; writeReferredParticleCloud no;
        pairModel pairSpringSliderDashpot;
        pairSpringSliderDashpotCoeffs {{ useEquivalentSize no; {CONTACT} }};
        wallModel wallSpringSliderDashpot;
        wallSpringSliderDashpotCoeffs {{ useEquivalentSize no; youngsModulus {YOUNG}; poissonsRatio 0.35; {CONTACT} }};
        U U.water;
    }}
}}
cloudFunctions {{}}""")


def write_case(case, cells, until, cores):
    foam.pipe_grid(case, foam.GRIDS[cells])
    foam.control(case, "DPMFoam", STEP, until)
    foam.numerics(case, cores)
    foam.velocity_field(case, "U.water")
    foam.pressure_field(case, "type fixedFluxPressure; value uniform 0;", {
        "shape": "square",
        "values": f"frequency {1 / foam.PERIOD:.12g}; amplitude {DRIVE * foam.LENGTH:.12g}; scale 1; level 0; t0 {-foam.PERIOD / 4};"})
    foam.write(case, "constant/transportProperties", "dictionary",
               "continuousPhase water; rho.water 1000; transportModel Newtonian; nu 1e-06;")
    foam.write(case, "constant/turbulenceProperties.water", "dictionary", "simulationType laminar;")
    foam.write(case, "constant/g", "uniformDimensionedVectorField", "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);")
    cloud(case)


def dpmfoam(cells, until, cores):
    case = f"dpmfoam.{cells}.{cores}"
    shutil.rmtree(case, ignore_errors=True)
    write_case(case, cells, until, cores)
    result = foam.solve(case, "DPMFoam", cores)
    print(f"  DPMFoam {cells}: largest Courant number {number(r'^Courant Number mean: .* max: ([0-9.e+-]+)', result.output):.2f}")
    return result


def ours(cells, until, cores):
    root, size = os.environ["ISAGO_ROOT"], {1920: "small", 20160: "large"}[cells]
    command = [os.path.join(root, "isago"), "run", os.path.join(root, "configs/pipe_oscillating"), "--set",
               f"grid.pipe.size={size}", "--set", "run.settle=0 s", "--set", f"run.time_step={STEP} s", "--until", f"{until} s",
               "--set", "output.pictures=never", "--set", "output.results=never",  # as DPMFoam
               "--threads", str(cores), "-o", f"isago.{cells}.{cores}", "--force", "--trace"]
    result = run(command, f"isago.{cells}.{cores}.log")
    fluid = number(r"work .* ms \(fluid ([\d.]+) ms", result.output)
    print(f"  ours {cells}: {1e-3 * fluid / STEP:.1f} s of work in the fluid's lane per simulated second")
    return result


def main(grids, until, cores):
    particles.prepare("pipe1", None)
    codes = {"dpmfoam": dpmfoam}
    if os.path.exists(os.path.join(os.environ["ISAGO_ROOT"], "configs/pipe_oscillating/scene.yaml")):
        codes["isago"] = ours
    for cells in grids:
        samples = {code: [] for code in codes}
        for _ in range(REPEATS):
            for code, measured in codes.items():
                result = measured(cells, until, cores)
                samples[code].append(rate(until * 1e3, result.wall, result.busy(cores), result.foreign))
        table(f"{cells} cells, 1600 grains, {until} s, {cores} core(s)", "simulated ms/s", samples)


if __name__ == "__main__":
    arguments = sys.argv[1:]
    main([int(arguments[0])] if arguments else [1920, 20160], float((arguments[1:2] or [0.01])[0]), int((arguments[2:3] or [1])[0]))
