(** [scc inflate ICON -o SHAPE]: from a drawing to a solid. *)

(** A solid with what was asked for. *)
type answer

val format : (answer, unit) Scc_json.Json_format.t
(** The format of the report ([specs/schema/inflate.schema.json]). *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Makes a solid from a drawn silhouette. *)
