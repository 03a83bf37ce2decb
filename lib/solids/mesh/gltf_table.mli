(** What is read of glTF 2.0. Each property of each kind of object is read, is still (it changes no place of a
    point) or is refused; so is each extension. *)

type t =
  | Read
  | Still
  | Refused of string  (** what it makes, in words *)

val kinds : (string * (string * t) list) list
(** The kinds of objects whose properties are checked, with all properties that the specification gives them.
    [target] is a set of displacements of a morphed mesh; [goal] is what a channel of an animation moves. *)

val extension : string -> t option
(** How an extension is treated, by its name; [None] for one that is not known here. *)

val check : kind:string -> Gltf_json.t -> (unit, Scc_base.Diag.t) result
(** [check ~kind v] is a fault (SC0320) if the value [v] is no object, or if it has a property or an extension that
    is refused or not known. The extensions of the whole file and of what an animation moves are not checked. *)

val undeclared : Gltf_json.t -> string option
(** [undeclared root] is an extension of the whole file that is not known here, or that moves things by itself. *)

val required : string -> bool
(** [required name] is true if a file that cannot be read without this extension can be read. *)

val quantization : string
(** The extension by which positions may be integers of 1 or 2 bytes. *)

val visibility : string
(** The extension by which a node and those inside of it may be hidden. *)

val draco : string
(** The extension by which the data of a primitive are compressed; the file may have them plain as well. *)
