// The methods that proofs over all samplers go through.
#pragma once

#include <string>

namespace foveola::test {

/// Every sampler, and some with settings that change their code. MAP and MASK are images (see
/// with_images).
inline const std::string every_method[] = {
    "od",
    "vp",
    "vp-rect",
    "fv",
    "fv:acuity=guenter,cutoff=120,measure=solid-angle",
    "fv:acuity=weier1",
    "fv-paper",
    "fv:acuity=watson",
    "fv:acuity=watson,eye=left,exponent=0.5,measure=solid-angle",
    "fv-map:file=MAP,extent=60",
    "mask:file=MASK",
    "mask:file=MASK,floor=0.5",
    "pointer",
    "pointer:radius=25,cutoff=60",
    "crop:azimuth=170,elevation=50,width=60,height=50",
    "hybrid:3*fv+1*od",
    "hybrid:0.2*vp-rect+0.5*fv:exponent=2+0.3*crop",
    "hybrid:0.5*fv-map:file=MAP,extent=100+0.5*mask:file=MASK"};

}  // namespace foveola::test
