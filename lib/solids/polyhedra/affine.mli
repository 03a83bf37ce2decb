(** Functions that are affine on each of finitely many convex polyhedra ({!Diagram}), or infinite there, or not
    known. *)

open Scc_exact

type value = Finite of Linear.t | Infinite | Unknown

include Diagram.S with type value := value

val plus : space -> Linear.t -> t -> t
(** [plus s form f] is [form] + [f]. *)

val sum : space -> dimension:int -> (Rat.t * t) list -> t
(** [sum s ~dimension terms] is the sum of functions over [dimension] variables, each times a number that is at
    least 0. A function times 0 is 0, also where it is infinite or unknown. Elsewhere an unknown term makes the sum
    unknown, and otherwise an infinite one makes it infinite. *)

val least : space -> t -> t -> t
(** The lesser value; where one has no value, that of the other. It is unknown where one of them is. *)

val greatest : space -> t -> t -> t
(** The greater value; where one has no value, that of the other. It is unknown where one of them is. *)
