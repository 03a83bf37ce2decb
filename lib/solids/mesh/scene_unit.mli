(** The statements [UNIT] of X3D in one file. *)

open Scc_exact

type t

val none : unit -> t
(** The units of a file before its first statement. *)

val state : t -> path:string -> Text.word -> category:string -> factor:Text.word -> unit
(** [state t ~path at ~category ~factor] adds a statement. Raises {!Scene.Refused} if the unit changes angles,
    if it is none, or if there is one of its category. *)

val length : t -> Rat.t
(** The unit of length in metres: 1 without a statement. Numbers of the first file stay as they are. Those of a
    file in an [Inline] are multiplied by its unit and divided by that of the file around it. *)
