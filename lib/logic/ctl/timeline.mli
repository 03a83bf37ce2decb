(** What varies piece by piece along a trajectory: a value at its start (offset 0), and then alternately on
    open intervals and at the cuts between them. The end of the trajectory is not part of it: it is the
    start of what comes next. *)

open Scc_exact

(** How long a trajectory is. *)
type extent =
  | Instant  (** a single instant: all that counts is the start *)
  | Lasts of Rat.t  (** positive: the offsets in [0, d) *)
  | Forever  (** the offsets in [0, infinity) *)

type 'a piece = {
  cut : Algebraic.t;
  at : 'a;  (** at the cut *)
  after : 'a;  (** from the cut to the next one, or to the end; both excluded *)
}

type 'a t = private {
  extent : extent;
  start : 'a;
  first : 'a;  (** from the start to the first cut, both excluded *)
  rest : 'a piece list;  (** increasing cuts, strictly inside the extent *)
}

val constant : extent -> 'a -> 'a t

val after_start : extent -> 'a -> 'a -> 'a t
(** What it is at the start, and what it is from then on. *)

val of_cuts :
  extent -> Rat.t list -> ('a -> 'a -> bool) -> (Rat.t -> 'a) -> 'a t
(** [of_cuts extent cuts equal f] is the function [f] when it changes at most at the cuts (in any order;
    those outside the extent do not matter). *)

val map : ('a -> 'b) -> 'a t -> 'b t

val map2 : ('a -> 'b -> 'c) -> 'a t -> 'b t -> 'c t
(** Both have one extent. *)

val refine :
  roots:('a -> Algebraic.t list) ->
  at:(Algebraic.t -> 'a -> 'b) ->
  inside:(Rat.t -> 'a -> 'b) ->
  'a t ->
  'b t
(** Cuts each piece further at those of the [roots] of its value that lie in it. The new value is [at r v]
    at an instant [r], and [inside r v] on an open piece that has the rational [r] inside. *)

val simplify : ('a -> 'a -> bool) -> 'a t -> 'a t
(** Without the cuts at which nothing changes. *)

(** {1 First instants} *)

(** The least offset of a set of offsets, or its infimum when that is not one of them ([attained] is
    false: the set begins right after it). *)
type moment = { offset : Algebraic.t; attained : bool }

val compare_moment : moment -> moment -> int

val first_after_start : ('a -> bool) -> 'a t -> moment option
(** When, after the start, the value first satisfies the predicate. *)

val sample : 'a t -> moment -> Algebraic.t
(** An offset at which the value is the one that begins at the moment: the moment itself when attained, and
    a rational inside the open piece otherwise. *)

val at : 'a t -> Algebraic.t -> 'a
(** The value at an offset of the extent. *)
