(** Files of scenes that are read for one mesh, and the prototypes in other files ([EXTERNPROTO]).

    An instance of such a prototype has words of several files. A word of a file of prototypes has a place beyond
    those of any other file: the place in its file, after the start of that file here. So {!path_of} tells the file
    of a word. All other words are of the file that names the prototypes. *)

open Scc_base

type prototype = {
  interface : Scene.interface;  (** what an instance can use *)
  fields : Scene.fields;
  body : path:string -> Text.word -> depth:int -> Scene.fields -> Scene.node * Scene.change list;
  (** [body ~path kind ~depth fields] is the first node of its body, of these fields, and what routes in it
      change. [kind] is the word in [path] that names the prototype there. *)
}

(** What a file declares: a prototype with its body, or one in another file. *)
type declared = {
  name : string;
  own : bool;  (** its body is in this file *)
  made : depth:int -> prototype;  (** as {!find} has it *)
}

type file = {
  prototypes : declared list;  (** those that the file declares outside of all nodes, in order *)
  length : Scc_exact.Rat.t;  (** its unit of length *)
}

type t
(** The files that were read, and how to read others. *)

val make :
  files:Beside.reader ->
  room:int ref ->
  read:(t -> path:string -> start:int -> depth:int -> string -> file) ->
  t
(** [read library ~path ~start ~depth text] has the prototypes of a file. Its nodes are inside of others, which are
    so deep. Its words have places from [start] on.
    Its faults are located by such places, or by those in the file. *)

val file :
  units:Scene_unit.t ->
  own:(string -> Scene.interface -> Scene.fields -> 'body -> prototype) ->
  elsewhere:(depth:int -> Scene.elsewhere -> prototype) ->
  (string * 'body Scene.prototype) list ->
  file
(** The file with these prototypes, the last one first. [own] and [elsewhere] make what is declared. *)

val files : t -> Beside.reader
(** All files, as [make] has them. *)

val room : t -> int ref
(** What is left for nodes, as {!Scene.spend} takes it. *)

val elsewhere :
  path:string -> name:string -> interface:Scene.interface -> Text.word -> Text.word list -> Scene.elsewhere
(** [elsewhere ~path ~name ~interface at words] is declared at the word [at] of [path], with these words of
    addresses. *)

val find : t -> depth:int -> length:Scc_exact.Rat.t -> Scene.elsewhere -> prototype
(** [find library ~depth ~length elsewhere] is the prototype in the first of its files that can be read.
    There it has the name that follows [#], as it stands or as addresses write it. Without [#] it is the first one
    whose body is in that file. Its interface is the one in [elsewhere]. A field there that the prototype does not
    have so is refused (SC0320).

    Without such a file, and in a file with another unit of length than [length], it is refused (SC0321). So it is
    when a prototype leads to itself, from file to file. *)

val strings : Text.word list -> string list
(** The strings of a field of strings: in quotes, with blanks in them or not. *)

val listed : string list -> string
(** The first of these names, for a message. *)

val file_of : string -> string
(** What stands before the [#] of an address. *)

(** {1 Places} *)

val path_of : t -> path:string -> Text.word -> string
(** The file of a word; [path] if it is of no file of prototypes. *)

val located : t -> Diag.t -> Diag.t
(** A diagnostic with its place in the file of that. *)
