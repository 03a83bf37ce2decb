(** Functions that are constant on each of finitely many convex polyhedra ({!Diagram}). A function has a number
    with two ends at each point, or no value. *)

open Scc_exact

(** A number of which two ends are known; they are equal if the number is known. *)
type value = { least : Rat.t; most : Rat.t }

include Diagram.S with type value := value

val sum : space -> (Rat.t * t) list -> t
(** The sum of functions, each times a number that is at least 0. It has a value where all of them have. *)

val least : space -> t -> t -> t
(** The lesser value, by each end; where one has no value, that of the other. *)

val greatest : space -> t -> t -> t
(** The greater value, by each end; where one has no value, that of the other. *)

val ends : space -> t -> t -> t
(** [ends s f g] is the function whose value has the lower end of that of [f] and the upper end of that of [g]. It
    has a value where both have. *)
