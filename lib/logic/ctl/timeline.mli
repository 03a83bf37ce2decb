(** Piecewise constant functions along a trajectory: a value at its start (offset 0), then alternately on open
    intervals and at the cuts between them. The end of the trajectory is not a part: it is the start of the next
    one. *)

open Scc_exact

(** The length of a trajectory. *)
type extent =
  | Instant  (** a single instant: only the start counts *)
  | Lasts of Rat.t  (** positive: the offsets from 0 on and below d *)
  | Forever  (** the offsets from 0 on *)

type 'a piece = {
  cut : Algebraic.t;
  at : 'a;  (** the value at the cut *)
  after : 'a;  (** the value from the cut to the next one, or to the end; both excluded *)
}

type 'a t = private {
  extent : extent;
  start : 'a;  (** the value at offset 0 *)
  first : 'a;  (** the value from the start to the first cut, both excluded *)
  rest : 'a piece list;  (** increasing cuts, strictly inside the extent *)
}

val constant : extent -> 'a -> 'a t
(** [constant extent v] is [v] at all offsets of the extent. *)

val after_start : extent -> 'a -> 'a -> 'a t
(** [after_start extent a b] is [a] at the start and [b] at all later offsets. *)

val of_cuts :
  extent -> Rat.t list -> ('a -> 'a -> bool) -> (Rat.t -> 'a) -> 'a t
(** [of_cuts extent cuts equal f] is the function [f], which changes at most at the cuts. They may be in any order;
    those outside the extent are ignored. *)

val of_pieces : extent -> start:'a -> first:'a -> 'a piece list -> 'a t option
(** [of_pieces extent ~start ~first rest] is the function with these values, or [None] if the cuts do not increase
    strictly inside the extent. *)

val map : ('a -> 'b) -> 'a t -> 'b t
(** [map f t] is [f] of each value, with the same cuts. *)

val map2 : ('a -> 'b -> 'c) -> 'a t -> 'b t -> 'c t
(** [map2 f a b] is [f] of the values of [a] and [b] at each offset. Both have one extent. *)

val refine :
  roots:('a -> Algebraic.t list) ->
  at:(Algebraic.t -> 'a -> 'b) ->
  inside:(Rat.t -> 'a -> 'b) ->
  'a t ->
  'b t
(** [refine ~roots ~at ~inside t] cuts each open piece of value [v] further at those of [roots v] that lie in it;
    they are increasing. The new value is [at r v] at an instant [r], and [inside r v] on an open piece that
    contains the rational [r]. *)

val simplify : ('a -> 'a -> bool) -> 'a t -> 'a t
(** [simplify equal t] is [t] without the cuts at which nothing changes. *)

(** {1 First instants} *)

(** The infimum of a set of offsets. [attained] is true if it belongs to the set, and false if the set begins right
    after it. *)
type moment = { offset : Algebraic.t; attained : bool }

val compare_moment : moment -> moment -> int
(** The order in time; at equal offsets, an attained moment comes first. *)

val first_after_start : ('a -> bool) -> 'a t -> moment option
(** [first_after_start test t] is the first moment after the start at which the value passes the test, if any. *)

val sample : 'a t -> moment -> Algebraic.t
(** [sample t m] is an offset with the value that begins at moment [m]: that of [m] itself if it is attained, and
    otherwise a rational inside the open piece after it. *)

val at : 'a t -> Algebraic.t -> 'a
(** [at t offset] is the value at an offset of the extent. *)
