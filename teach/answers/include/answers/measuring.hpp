// SPDX-License-Identifier: MIT
#pragma once
#include "answers/answer.hpp"

/// The steps of Measuring.
namespace texel::answers {

/// The truth at the middle of each pixel, RGBA, alpha 1 where there is one and it is finite: the rows from
/// `first` to before `end`, into a picture that is black and transparent there.
void add_truth_rows(image::ImageF& picture, const Truth& truth, int first, int end);

/// The error at each pixel in red, alpha 1 where it is known. Where the picture is not finite the error is
/// NaN. Both have the same size; alpha is 1 where the object is, and where there is a truth.
image::ImageF error_picture(const image::ImageF& picture, const image::ImageF& truth,
                            const app::Measure& measure);

/// Of an error picture and the truth that it was made with.
app::ErrorFigures figures_of(const image::ImageF& error, const image::ImageF& truth);

/// Finds max_aside and outline_pixels: of the picture and truth that the error picture was made with.
void tell_outlines_apart(app::ErrorFigures& figures, const image::ImageF& error, const image::ImageF& picture,
                         const image::ImageF& truth, const app::Measure& measure);

/// How far off the truth is by its own samples, in the measure's unit: it is found again from other places in
/// every 25th pixel, and this is the root mean square of what both differ by, over the square root of 2.
/// Below a float32's rounding where the truth has no samples. `picture` has the truth.
double truth_error(const image::ImageF& picture, const Truth& truth, const app::Measure& measure);

/// The error picture in colours, from 0 to `scale` (image::heat; magenta where it is not finite).
image::Image8 error_map(const image::ImageF& error, double scale);

}  // namespace texel::answers
