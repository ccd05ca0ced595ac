// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "newest_pair.h"

namespace posture::app {

using Lock = std::unique_lock<std::mutex>;

void NewestPair::set(Slot& slot, const Side& side) {
  {
    const Lock lock(mutex_);
    slot.side = side;
    slot.waits = true;
  }
  changed_.notify_one();
}

void NewestPair::setSource(const Side& source) { set(source_, source); }
void NewestPair::setTarget(const Side& target) { set(target_, target); }

bool NewestPair::complete() const { return source_.side.message && target_.side.message; }

bool NewestPair::again() {
  {
    const Lock lock(mutex_);
    if (!complete()) return false;
    again_ = true;
  }
  changed_.notify_one();
  return true;
}

std::optional<Pair> NewestPair::take() {
  Lock lock(mutex_);
  changed_.wait(lock, [this] {
    return closed_ || (complete() && (source_.waits || target_.waits || again_));
  });
  if (closed_) return std::nullopt;
  // The half that was given up is new still: else two streams would outdate each other for ever.
  const bool given_up = outdatedUnlocked();
  for (Slot* slot : {&source_, &target_}) {
    slot->was_new = slot->waits || (given_up && slot->was_new);
    slot->waits = false;
  }
  again_ = false;
  return Pair{source_.side, target_.side};
}

bool NewestPair::outdated() const {
  const Lock lock(mutex_);
  return outdatedUnlocked();
}

bool NewestPair::outdatedUnlocked() const {
  return (source_.was_new && !target_.was_new && target_.waits) ||
         (target_.was_new && !source_.was_new && source_.waits);
}

void NewestPair::close() {
  {
    const Lock lock(mutex_);
    closed_ = true;
  }
  changed_.notify_one();
}

bool NewestPair::closed() const {
  const Lock lock(mutex_);
  return closed_;
}

}  // namespace posture::app
