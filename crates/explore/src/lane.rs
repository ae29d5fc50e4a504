//! Places for what runs at once, and who waits for one.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::oneshot::{Sender, channel};

/// So many places, handed out in the order in which they were asked for.
pub(crate) struct Lane(Mutex<State>);

struct State {
    free: usize,
    waiting: VecDeque<Sender<Place>>,
}

/// A place in a lane, until it is dropped.
pub(crate) struct Place(Arc<Lane>);

impl Lane {
    pub(crate) fn new(size: usize) -> Arc<Self> {
        Arc::new(Self(Mutex::new(State { free: size, waiting: VecDeque::new() })))
    }

    /// A place, if there is a free one.
    pub(crate) fn free_place(self: &Arc<Self>) -> Option<Place> {
        let mut state = self.state();
        state.free = state.free.checked_sub(1)?;
        Some(Place(Arc::clone(self)))
    }

    /// A place, when there is one.
    pub(crate) async fn place(self: &Arc<Self>) -> Place {
        loop {
            let receiver = {
                let mut state = self.state();
                if let Some(left) = state.free.checked_sub(1) {
                    state.free = left;
                    return Place(Arc::clone(self));
                }
                let (sender, receiver) = channel();
                state.waiting.push_back(sender);
                receiver
            };
            // A sender is dropped only after it has sent a place.
            if let Ok(place) = receiver.await {
                return place;
            }
        }
    }

    /// Whether somebody waits for a place.
    pub(crate) fn is_crowded(&self) -> bool {
        self.state().waiting.iter().any(|sender| !sender.is_closed())
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let next = {
            let mut state = self.0.state();
            let next = state.waiting.pop_front();
            if next.is_none() {
                state.free += 1;
            }
            next
        };
        // One that waits no more gives the place back, which drops it once more: then it is the turn of the one behind.
        if let Some(next) = next {
            drop(next.send(Self(Arc::clone(&self.0))));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::future::Future;
    use std::pin::pin;
    use std::task::{Context, Poll, Waker};

    use super::*;

    fn poll<T>(future: std::pin::Pin<&mut impl Future<Output = T>>) -> Option<T> {
        match future.poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(value) => Some(value),
            Poll::Pending => None,
        }
    }

    #[test]
    fn places_go_to_those_who_wait_in_their_order() {
        let lane = Lane::new(1);
        let first = lane.free_place().unwrap();
        assert!(lane.free_place().is_none());
        let (mut second, mut third) = (pin!(lane.place()), pin!(lane.place()));
        assert!(poll(second.as_mut()).is_none() && poll(third.as_mut()).is_none());
        assert!(lane.is_crowded());
        drop(first);
        assert!(poll(third.as_mut()).is_none(), "it is the turn of the second");
        drop(poll(second.as_mut()).unwrap());
        let last = poll(third.as_mut()).unwrap();
        assert!(!lane.is_crowded());
        drop(last);
        assert!(lane.free_place().is_some());
    }

    #[test]
    fn who_waits_no_more_is_passed_over_and_no_place_is_lost() {
        let lane = Lane::new(1);
        let first = lane.free_place().unwrap();
        {
            let mut gone = pin!(lane.place());
            assert!(poll(gone.as_mut()).is_none());
        }
        assert!(!lane.is_crowded());
        let mut waiting = pin!(lane.place());
        assert!(poll(waiting.as_mut()).is_none());
        drop(first);
        drop(poll(waiting.as_mut()).unwrap());
        // One that is given a place and then leaves without having seen it.
        let first = lane.free_place().unwrap();
        {
            let mut gone = pin!(lane.place());
            assert!(poll(gone.as_mut()).is_none());
            drop(first);
        }
        assert!(lane.free_place().is_some());
    }
}
