(** Reading files and models. *)

open Scc_base
open Scc_exact

val read : ?max_bytes:int -> ?smaller:string -> Console.t -> string -> (Source.t, Diag.t) result
(** The content of a file; ["-"] is standard input. A file that cannot be read, or has more than [max_bytes]
    (default: 64 MiB), is SC0101. Of one that has more, [smaller] is the hint how to make it smaller. *)

val standard_input : string
(** The name of standard input in diagnostics. *)

val cannot_read : ?hint:string -> string -> string -> Diag.t
(** [cannot_read name reason] is the error SC0101. *)

val beside : Console.t -> Scc_mesh.Beside.reader
(** Reads a file that a mesh file of the command line names. *)

val mesh_reader : Console.t -> string -> Scc_loading.Loaded.reader
(** [mesh_reader c model path] reads a mesh that a model names, relative to the folder of the model. *)

val text : ?smaller:string -> Console.t -> string -> (Source.t, Diag.t list) result
(** Reads a file as {!read} does, and adds its text to the console. *)

val warned : Console.t -> string -> (Source.t, Diag.t list) result
(** Reads a file as {!text} does, and reports {!Direction.warnings}: for commands that read a text and load no
    model. *)

val given : Console.t -> name:string -> string -> Source.t
(** [given c ~name text] makes a source of a text of the command line, adds it to the console, and reports
    {!Direction.warnings}. *)

val check_overrides : string list -> (unit, Diag.t list) result
(** Checks the names of parameters with values on the command line. A name that occurs twice is SC0212. *)

val report : Console.t -> Scc_loading.Loaded.t -> Diag.t list -> unit
(** [report console l diagnostics] reports what was found in the model; what is of no place in it is reported of
    its file. *)

val no_check : Code.t -> Span.t -> string -> Scc_property.Property.check list -> Diag.t
(** [no_check code at name checks] is the error that the model has no check [name]. Its hint is a similar name. *)

val model :
  ?given:Span.t ->
  ?narrowed:(string * (Scc_calculus.Ranges.bound * Scc_calculus.Ranges.bound)) list ->
  ?parametric:Scc_elaborate.Asked.given ->
  ?source:Source.t ->
  ?read_file:Scc_loading.Loaded.reader ->
  Console.t ->
  overrides:(string * Rat.t) list ->
  string ->
  (Scc_loading.Loaded.t, Diag.t list) result
(** Reads and loads the file, or [source] as its content. Its texts are added to the console. [read_file] reads
    imports and meshes (default: from files). [given] is the place of [overrides] in errors (default: the command
    line). [parametric] is as for {!Scc_loading.Loaded.load}. *)
