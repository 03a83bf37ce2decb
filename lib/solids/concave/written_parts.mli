(** Convex parts of a drawn solid as files, exactly. *)

open Scc_exact

val compound : name:string -> mass:Rat.t -> Parts.t -> string
(** A text in the modelling language: a template for each part, and a compound of all. The parts have shares of
    the mass by their volumes; each is glued to others where they touch ({!Joints}). Parts that no areas connect
    are compounds [name_1], [name_2], …. *)

val obj : Parts.t -> string
(** A text in the format OBJ: each part is an object with corners of its own. Coordinates are integers or
    fractions p/q. *)
