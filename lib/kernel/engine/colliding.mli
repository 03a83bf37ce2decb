(** The pairs of bodies that collide now, with the outcomes of their collisions by number. Thousands of pairs may
    collide at one instant, and each collision that happens changes only the pairs of its two bodies. Pairs are
    in the order of their first leaves, and the outcomes of each pair in the order in which they were found. *)

type ('body, 'outcome) t

val create : int -> first:('body -> int) -> age:('body -> int) -> ('body, 'outcome) t
(** [create leaves ~first ~age] has no pairs, for a network of this many leaves. [first] is the first leaf of a
    body, which identifies it. [age] is a number that changes whenever the body does. *)

val meet : ('body, 'outcome) t -> 'body -> 'body -> unit
(** [meet t one two] adds the pair, if it is not there yet. The body with the lesser first leaf comes first. This
    function, {!part} and {!changed} take O(log n) steps for each pair concerned, for n pairs. *)

val part : ('body, 'outcome) t -> int -> unit
(** [part t first] removes all pairs of the body with this first leaf, which takes another course. *)

val changed : ('body, 'outcome) t -> int -> unit
(** [changed t first] marks all pairs of the body with this first leaf, which may have changed on its course, for
    the next {!find}. *)

(** What may come of a pair. *)
type 'outcome found = {
  outcomes : 'outcome list;
  busy : bool;  (** one of the outcomes comes before anything stops its bodies *)
  stops : int list;  (** the first leaves of those of the two bodies that are to stop *)
}

val find : ('body, 'outcome) t -> ('body -> 'body -> 'outcome found) -> unit
(** [find t found] computes what may come of the pairs that are new, and of the marked pairs in which the age
    of a body differs. *)

val count : ('body, 'outcome) t -> int
(** The number of all outcomes, as {!find} found them last. *)

val nth : ('body, 'outcome) t -> int -> 'outcome
(** The outcome with a number, from 0 to {!count} - 1. Any other number is a bug. *)

val stopping : ('body, 'outcome) t -> int list
(** The first leaves of the bodies that are to stop by some pair and are in no busy pair, in order, as {!find}
    found them last. It takes O(n log n) steps for the n pairs that stop bodies. *)

val bodies : ('body, 'outcome) t -> 'body list
(** All bodies that are in pairs, in the order of their first leaves. It takes O(n log n) steps for n pairs. *)
