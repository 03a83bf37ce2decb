(** The values of the parameters for which a check holds, as JSON: the member [where] of a property in the
    report of [scc check]. [specs/schema/common.schema.json] describes it. *)

open Scc_polyhedra
open Scc_regions
open Scc_json

val format : (Where.t, unit) Json_format.t
(** The format of the whole member. Constraints are those of the minimal form, in their stored order.
    Coefficients are integers, and those that are 0 are left out. *)

val polyhedron_format : ((int -> string) * Polyhedron.t, unit) Json_format.t
(** The format of all constraints of a polyhedron, with the names of its variables. *)

val form_format : ((int -> string) * Linear.t, unit) Json_format.t
(** The format of a linear form, with the names of its variables. *)

val where : Where.t -> Json.t
(** The whole member in {!format}. *)

(** A probability as a function of the parameters, with its parts or without. *)
type chances = { chances : Chances.t; with_parts : bool }

val chances_fields : (chances, unit) Json_format.members
(** Its extremes, its mean, and its parts. *)
