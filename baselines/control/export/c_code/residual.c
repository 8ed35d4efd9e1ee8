
/* A learned correction: u = sat(u_base + SCALE a), the actions a in [-1, 1] from a network. */

static struct {
    real integral[2];    /* rad s */
    real past[PAST][5];  /* errors of the angles in tolerances, actions; the last first */
    real hidden[HIDDEN]; /* of a recurrent cell */
} seen;

static real clip(real value, real low, real high) {
    return value < low ? low : value > high ? high : value;
}

static real normalised(real u) {
    return (u - REAL(0.5) * (U_MIN + U_MAX)) / (REAL(0.5) * (U_MAX - U_MIN));
}

static int observe(int k, const real y[6], const real base[2], real *features) {
    static const real tolerance[6] = TOLERANCE;
    int n = 0;
#if SEES_ERROR
    for (int i = 0; i < 6; i++) {
        features[n++] = (y[i] - STATE[k][i]) / tolerance[i];
    }
#endif
#if SEES_INTEGRAL
    for (int i = 0; i < 2; i++) {
        features[n++] = seen.integral[i] / INTEGRAL_SCALE;
    }
#endif
#if SEES_VOLTAGES
    for (int i = 0; i < 2; i++) {
        features[n++] = normalised(base[i]);
    }
    for (int i = 0; i < 2; i++) {
        features[n++] = normalised(NOMINAL[k][i]);
    }
    for (int i = 3; i < 5; i++) {
        features[n++] = seen.past[0][i];
    }
#endif
#if SEES_ESTIMATE
    for (int i = 0; i < 3; i++) {
        features[n++] = memory.disturbance[i] / DISTURBANCE_SCALE;
    }
    for (int i = 0; i < 2; i++) {
        features[n++] = normalised(memory.rotors[i]);
    }
#endif
#if SEES_PREVIEW
    for (int i = 0; i < PREVIEWED; i++) {
        features[n++] = PREVIEW[k][i];
    }
#endif
#if SEES_PAST
    {
        static const int steps[] = PAST_STEPS;
        for (int j = 0; j < (int)(sizeof steps / sizeof *steps); j++) {
            for (int i = 0; i < 5; i++) {
                features[n++] = seen.past[steps[j] - 1][i];
            }
        }
    }
#endif
    (void)y;
    (void)base;
    (void)k;
    (void)tolerance;
    for (int i = 0; i < n; i++) {
        features[i] = clip(features[i], -FEATURE_CLIP, FEATURE_CLIP);
    }
    return n;
}

/* out = weight in + bias; `weight` is stored by columns, so that compilers vectorise the inner loop. */
static void affine(const real *weight, const real *bias, const real *in, int inputs, int outputs, real *restrict out) {
    for (int i = 0; i < outputs; i++) {
        out[i] = bias[i];
    }
    for (int j = 0; j < inputs; j++) {
        const real *column = weight + outputs * j, value = in[j];
        for (int i = 0; i < outputs; i++) {
            out[i] += column[i] * value;
        }
    }
}

#if RECURRENT
/* A GRU cell; its gates are reset, update, new. */
static void recur(const real *features) {
    static real x[3 * HIDDEN], h[3 * HIDDEN];
    affine(CELL_INPUT, CELL_INPUT_BIAS, features, FEATURES, 3 * HIDDEN, x);
    affine(CELL_HIDDEN, CELL_HIDDEN_BIAS, seen.hidden, HIDDEN, 3 * HIDDEN, h);
    for (int i = 0; i < HIDDEN; i++) {
        const real reset = REAL(0.5) + REAL(0.5) * TANH(REAL(0.5) * (x[i] + h[i]));
        const real update = REAL(0.5) + REAL(0.5) * TANH(REAL(0.5) * (x[HIDDEN + i] + h[HIDDEN + i]));
        const real fresh = TANH(x[2 * HIDDEN + i] + reset * h[2 * HIDDEN + i]);
        seen.hidden[i] = fresh + update * (seen.hidden[i] - fresh);
    }
}
#endif

#if CORRECTS_MODEL && !DELAY
/* The last period of the model, from its state before, with the voltages u in place of the base's. */
static void simulate_again(const struct model *before, const real u[2]) {
    real change[6];
    for (int i = 0; i < 6; i++) {
        memory.x[i] = before->x[i];
        memory.carry[i] = before->carry[i];
    }
    memory.rotors[0] = before->rotors[0];
    memory.rotors[1] = before->rotors[1];
    predict(memory.x, memory.rotors, u, PERIOD, change);
    for (int i = 0; i < 6; i++) {
        add(i, change[i]);
    }
}
#endif

void heli_reset(void) {
    base_reset();
    for (int i = 0; i < 2; i++) {
        seen.integral[i] = REAL(0.0);
    }
    for (int i = 0; i < PAST; i++) {
        for (int j = 0; j < 5; j++) {
            seen.past[i][j] = REAL(0.0);
        }
    }
    for (int i = 0; i < HIDDEN; i++) {
        seen.hidden[i] = REAL(0.0);
    }
}

void heli_step(real t, const real y[6], real u[2]) {
    static const real tolerance[6] = TOLERANCE;
    static real features[WIDEST], layer[WIDEST];
    real base[2], applied[2], action[2];
    const int k = index_of(t);
    if (!is_measured(y)) {
        u[0] = u[1] = SAFE_VOLTAGE;
        base_miss(u);
        return;
    }
    base_control(t, y, base);
    applied[0] = saturate(base[0]);
    applied[1] = saturate(base[1]);
#if CORRECTS_MODEL && !DELAY
    const struct model before = memory;
#endif
    base_remember(t, base, applied);
    observe(k, y, base, features);
    network(features, layer);
    for (int i = 0; i < 2; i++) {
        action[i] = clip(features[i], -REAL(1.0), REAL(1.0));
        u[i] = saturate((SATURATED_FIRST ? applied[i] : base[i]) + SCALE * action[i]);
    }
#if CORRECTS_MODEL && DELAY
    memory.pending[DELAY - 1][0] = u[0];
    memory.pending[DELAY - 1][1] = u[1];
#elif CORRECTS_MODEL
    simulate_again(&before, u);
#endif
    for (int i = PAST - 1; i > 0; i--) {
        for (int j = 0; j < 5; j++) {
            seen.past[i][j] = seen.past[i - 1][j];
        }
    }
    for (int i = 0; i < 3; i++) {
        seen.past[0][i] = (y[2 * i] - STATE[k][2 * i]) / tolerance[2 * i];
    }
    for (int i = 0; i < 2; i++) {
        seen.past[0][3 + i] = action[i];
        seen.integral[i] += PERIOD * (y[2 * i] - STATE[k][2 * i]);
    }
}
