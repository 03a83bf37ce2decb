(** The constant parts of a model: its solids and its leaves. *)

open Scc_geometry
open Scc_calculus
open Scc_json

val solid_format : (string * Solid.t, unit) Json_format.t
(** The format of a solid with the name of its template. *)

(** A leaf with its family ({!Scc_calculus.Families}), and its parts with the rows of their solids. *)
type t = { leaf : Model.leaf; family : int; parts : (Model.part * int) list; turns : bool }

val format : (t, unit) Json_format.t
(** The format of a leaf. *)

val leaves : solids:Rows.t -> Model.t -> t list
(** The leaves with their parts, in order. Their solids are added as rows. *)
