// boost.cpp - Boost.Math's spherical harmonics as an impl of `values`.
#include <boost/math/special_functions/spherical_harmonic.hpp>

#include <cmath>

namespace {

// Boost's complex Y has the Condon-Shortley factor; the real basis takes sqrt(2) Re for m > 0, sqrt(2) Im for m < 0.
template <class Real> void evaluate(int bands, const Real dir[3], Real *y)
{
    const Real theta = std::acos(dir[2]), phi = std::atan2(dir[1], dir[0]), root = std::sqrt(Real(2));
    for (int l = 0; l < bands; l++) {
        y[l * l + l] = boost::math::spherical_harmonic_r(unsigned(l), 0, theta, phi);
        for (int m = 1; m <= l; m++) {
            y[l * l + l + m] = root * boost::math::spherical_harmonic_r(unsigned(l), m, theta, phi);
            y[l * l + l - m] = root * boost::math::spherical_harmonic_i(unsigned(l), m, theta, phi);
        }
    }
}

} // namespace

extern "C" void bench_boost_f32(int bands, const float dir[3], float *y) { evaluate(bands, dir, y); }
extern "C" void bench_boost_f64(int bands, const double dir[3], double *y) { evaluate(bands, dir, y); }
