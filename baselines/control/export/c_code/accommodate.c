
/* The reference with the pitch and the thrusts that also outweigh the estimated disturbance. */
static void accommodate(real x[6], real v[2]) {
    const real *d = memory.disturbance;
    const real across = v[0] * SIN(x[4]) - d[0] / (B1 * COS(x[2]));
    const real upright = v[0] * COS(x[4]) - d[1] / B2;
    real tilt = ATAN2(across, upright > LEAST_LIFT ? upright : LEAST_LIFT);
    if (tilt < PITCH_MIN) {
        tilt = PITCH_MIN;
    }
    if (tilt > PITCH_MAX) {
        tilt = PITCH_MAX;
    }
    v[1] -= (d[2] + A3 * COS(x[2]) * (SIN(tilt) - SIN(x[4]))) / B3;
    v[0] = SQRT(across * across + upright * upright);
    x[4] = tilt;
}
