(** Convex parts of a drawn solid as files, exactly. *)

open Scc_exact

val compound : name:string -> mass:Rat.t -> Parts.t -> string
(** In the modelling language: a template for each part, and a compound of them all. The parts have their
    shares of the mass, by volume; each is glued to others where they touch ({!Joints}). *)

val obj : Parts.t -> string
(** As OBJ, each part an object with corners of its own. Coordinates are integers or fractions p/q. *)
