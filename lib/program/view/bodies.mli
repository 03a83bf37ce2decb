(** The constant parts of a model: its solids and its leaves. *)

open Scc_calculus
open Scc_json

val leaves : solids:Rows.t -> Model.t -> Json.t
(** The leaves with their parts, in order. Their solids are added as rows. *)

val families : Model.t -> Json.t
(** The names of the families, which leaves refer to by number ({!Scc_calculus.Families}). *)
