(** The probability of "f until g" within [a, T], as a function of T: all times at which it changes up to a
    greatest T, and its values there. *)

open Scc_exact
open Scc_chance

val moments : most:int -> Decisions.question -> int -> Timeline.moment list option
(** [moments ~most q s] is the times T, up to the end of the bound of [q], at which the probability from node [s]
    may change: the first is the beginning of the bound. At a moment that is not attained it changes right after
    it. It is [None] if the bound has no end. It may raise {!Layers.Too_many} where there are more than [most]
    instants. *)

val horizons : Timeline.moment list -> high:Rat.t -> (Timeline.moment * Rat.t) list
(** [horizons moments ~high] is a time T for each moment, as of {!moments}: the moment itself if it is attained and
    rational, and otherwise a time after it and before the next one. Moments after which no T is at most [high] are
    left out. *)

val values : Decisions.question -> Effort.t -> int -> Rat.t list -> Answer.t list
(** [values q effort s times] is the probability from node [s] within [a, T], for each T of [times], where a is the
    beginning of the bound of [q]. No time is after its end. One pass through the layers has all values if a is 0;
    otherwise each T has a pass of its own. *)
