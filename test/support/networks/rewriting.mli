(** Behaviours written in another way: laws that keep what they offer, now and after each time, tried at random. *)

open Scc_exact
open Scc_calculus

val model : int -> Model.t -> State.t -> Model.t * State.t
(** [model seed m s]: the same network with other behaviours, bisimilar to those it had, one by one. What was
    defined keeps its number. Sums get nil, repetitions, waiting and idle company, and are commuted and
    distributed over eps; names are unfolded and new ones given; delays are cut in two. *)

val waiting : Rat.t -> State.t -> State.t
(** [waiting d s]: every behaviour B as B + eps(d). nil: time is cut after d, and nothing comes of it. *)

val without_behaviours : State.t -> State.t
(** All behaviours are nil. *)
