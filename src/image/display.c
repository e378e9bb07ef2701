/* SPDX-License-Identifier: Apache-2.0 */
/* Linear light to bytes for looking at: exposure and the sRGB curve (IEC 61966-2-1). */
#include "image.h"

#include <math.h>
#include <string.h>

/* Display value 0.9 on the sRGB curve, as linear light. */
static const double TARGET_LIGHT = 0.7874;
static const double PERCENTILE = 0.99;

/* Positive floats order like their bits: the upper ones make bins 1/64 of a factor 2 wide. */
enum { BIN_SHIFT = 17, BIN_COUNT = 0x7f800000 >> BIN_SHIFT };

static void display_channels(const murk_image *image, int channel[3])
{
    static const char *const NAMES[3] = {"R", "G", "B"};
    for (int i = 0; i < 3; i++)
        channel[i] = murk_image_channel(image, NAMES[i]);
    if (channel[0] >= 0 && channel[1] >= 0 && channel[2] >= 0)
        return;
    int single = murk_image_channel(image, "Y");
    channel[0] = channel[1] = channel[2] = single >= 0 ? single : 0;
}

double murk_display_value(double light)
{
    if (!(light > 0.0))
        return 0.0;
    double value = light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1.0 / 2.4) - 0.055;
    return fmin(value, 1.0);
}

double murk_display_linear(double value)
{
    return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

static uint8_t display_byte(double light)
{
    return (uint8_t)(murk_display_value(light) * 255.0 + 0.5);
}

void murk_display_encode(const murk_image *image, double exposure, uint8_t *rgb)
{
    int channel[3];
    display_channels(image, channel);
    double gain = exp2(exposure);
    size_t count = (size_t)image->width * image->height;
    float last = 0.0f;
    uint8_t byte = 0;
    for (size_t p = 0; p < count; p++)
        for (int i = 0; i < 3; i++) {
            float value = image->pixels[p * image->channels + channel[i]];
            if (value != last) { /* a single band holds the same value three times */
                last = value;
                byte = isfinite(value) ? display_byte(gain * value) : 0;
            }
            rgb[3 * p + i] = byte;
        }
}

bool murk_display_data(const murk_image *image, double exposure, uint8_t *rgba)
{
    static const char *const NAMES[4] = {"R", "G", "B", "A"};
    int channel[4];
    for (int i = 0; i < 4; i++)
        if ((channel[i] = murk_image_channel(image, NAMES[i])) < 0)
            return false;
    const double color = exp2(exposure), gain[4] = {color, color, color, 1};
    size_t count = (size_t)image->width * image->height;
    for (size_t p = 0; p < count; p++)
        for (int i = 0; i < 4; i++) {
            double value = gain[i] * image->pixels[p * image->channels + channel[i]];
            rgba[4 * p + i] = (uint8_t)(value > 0 ? fmin(value, 1) * 255 + 0.5 : 0);
        }
    return true;
}

double murk_display_exposure(const murk_image *image)
{
    static const float WEIGHT[3] = {0.2126f, 0.7152f, 0.0722f};
    int channel[3];
    display_channels(image, channel);
    uint64_t bins[BIN_COUNT] = {0};
    uint64_t lit = 0;
    size_t count = (size_t)image->width * image->height;
    for (size_t p = 0; p < count; p++) {
        const float *pixel = image->pixels + p * image->channels;
        float luminance = 0.0f;
        for (int i = 0; i < 3; i++)
            luminance += WEIGHT[i] * pixel[channel[i]];
        if (isfinite(luminance) && luminance > 0.0f) {
            uint32_t bits;
            memcpy(&bits, &luminance, sizeof bits);
            bins[bits >> BIN_SHIFT]++;
            lit++;
        }
    }
    if (lit == 0)
        return 0.0;
    uint64_t above = (uint64_t)((1.0 - PERCENTILE) * (double)lit), seen = 0;
    uint32_t bin = BIN_COUNT;
    while (seen <= above)
        seen += bins[--bin];
    uint32_t bits = bin << BIN_SHIFT | 1u << (BIN_SHIFT - 1);
    float luminance;
    memcpy(&luminance, &bits, sizeof luminance);
    return log2(TARGET_LIGHT / luminance);
}
