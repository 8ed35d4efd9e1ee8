/* Feedforward and state feedback, linear in between the samples. */

static void base_reset(void) {
}

static void base_control(real t, const real y[6], real u[2]) {
    real s = t / PERIOD, v[2];
    real sample;
    int k;
    if (!(s > REAL(0.0))) {
        s = REAL(0.0);
    }
    if (s > (real)LAST) {
        s = (real)LAST;
    }
    sample = (real)(int)(s + REAL(0.5));
    if (FABS(s - sample) <= ROUNDING_OF_TIME * (s + REAL(1.0))) { /* a sample, but for the rounding of t */
        s = sample;
    }
    k = (int)s < LAST ? (int)s : LAST - 1;
    s -= (real)k;
    for (int i = 0; i < 2; i++) {
        v[i] = FEEDFORWARD[k][i] + s * (FEEDFORWARD[k + 1][i] - FEEDFORWARD[k][i]);
        for (int j = 0; j < 6; j++) {
            const real x = STATE[k][j] + s * (STATE[k + 1][j] - STATE[k][j]);
            const real gain = GAIN[k][6 * i + j] + s * (GAIN[k + 1][6 * i + j] - GAIN[k][6 * i + j]);
            v[i] -= gain * (y[j] - x);
        }
    }
    u[0] = front_voltage(REAL(0.5) * (v[0] + v[1]));
    u[1] = back_voltage(REAL(0.5) * (v[0] - v[1]));
}

static void base_remember(real t, const real wanted[2], const real applied[2]) {
    (void)t;
    (void)wanted;
    (void)applied;
}

static void base_miss(const real applied[2]) {
    (void)applied;
}
