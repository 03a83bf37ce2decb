(** The library against brute force. *)

type group
(** Two bodies, with what both sides have made of them. *)

val group : Shapes.body -> Shapes.body -> group
val aim : group -> Aim.pair

val size : group -> int
(** How many directions a query of the brute force looks at. *)

val show : group -> string

exception Differs of string
(** What was asked, and both answers. *)

(** What beside the case is looked at; each costs more than the case itself. *)
type extras = {
  swapped : bool;  (** the same seen from the second body *)
  fresh : bool;  (** the same asked of an obstacle that nothing was asked of before *)
  all_axes : bool;  (** the fast brute force with all axes *)
  naive : bool;  (** the slow one, and the features in contact *)
}

val case : group -> extras -> Aim.case -> string
(** Every query for one case, also at the collision. Returns the outcome, in a word or two. Raises {!Differs}. *)
