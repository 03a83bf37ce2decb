(** The last net: whatever happens, scc ends with a message and a documented exit code. *)

open Scc_base

val invalid : Console.t -> Diag.t list -> Exit_code.t
(** Reports why there can be no result: exit 3. In JSON mode the diagnostics are the document. *)

val run : Console.t -> (unit -> Exit_code.t) -> Exit_code.t
(** Runs a command and turns exceptions into exit codes: an output that failed (4), an output that nobody
    reads any more (4, silently), no memory left (4), our own bugs and everything unforeseen (70). *)
