(** For which values of the parameters a check holds, as JSON: the member [where] of a property in the report of
    [scc check]. [specs/schema/common.schema.json] describes it. *)

open Scc_polyhedra
open Scc_regions

val where : Where.t -> Json.t
(** Constraints are those of the minimal form, in the order in which they are kept; coefficients that are 0 are
    left out, and the others are integers. *)

val constraint_ : name:(int -> string) -> Constraint.t -> Json.t
(** One constraint, in the same form, over variables of these names. *)

val polyhedron_of : name:(int -> string) -> Polyhedron.t -> Json.t
(** All its constraints. *)

val form : name:(int -> string) -> Linear.t -> Json.t
(** [{"coefficients", "constant"}], likewise. *)
