(** [scc export]: a run for other programs. *)

open Scc_verdicts
open Cmdliner

val command : Exit_code.t Cmd.t
(** Writes a run for other programs: glTF, X3D, VTK, Simularium, OBJ, tables. *)
