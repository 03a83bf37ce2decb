(** The commands of the server: checks, and pages that show their runs. Each works in a process of its own, shows
    its progress, and can be cancelled. *)

open Scc_base
open Scc_json

(** What the program does for a command, in a process of its own. [read_file] reads imports and meshes, [check] is
    the name of a check. *)
type work = {
  decide :
    read_file:(string -> (string, string) result) ->
    progress:(string -> unit) ->
    check:string option ->
    Source.t ->
    (Session.verdict list, Diag.t list) result;
  page :
    read_file:(string -> (string, string) result) ->
    progress:(string -> unit) ->
    check:string option ->
    Source.t ->
    string ->
    (unit, Diag.t list) result;  (** writes a page to a path *)
}

type t

val create : work -> Session.t -> send:(Json.t -> unit) -> decided:(Workspace.document -> unit) -> t
(** No command runs. [decided] is called when there are new verdicts of a document. *)

val names : string list
(** The commands. *)

val start : t -> id:Json.t -> Json.t -> unit
(** Carries out the params of [workspace/executeCommand]; the request with this id is answered at the end. Raises
    {!Rpc.Refused}. *)

val jobs : t -> Job.t list
(** The processes at work. *)

val cancel : t -> Json.t -> bool
(** Cancels the command of the request with this id; false if there is none. *)

val cancel_token : t -> Json.t -> unit
(** Cancels the command whose progress has this token. *)

val answered : t -> Json.t -> unit
(** The client has answered the request of the server with this id. *)

val ask : t -> string -> Json.t -> unit
(** Sends a request to the client whose answer does not matter. *)

val close : t -> unit
(** Ends all commands, and removes the pages. *)
