(** What is read of glTF 2.0: the properties of each kind of object, and the extensions, that are read or that
    leave the places of points as they are. *)

val check : kind:string -> Gltf_json.t -> (unit, Scc_base.Diag.t) result
(** [check ~kind v] is a fault (SC0320) if the object [v] has a property or an extension that is neither read nor
    known to change no geometry. The kinds are [glTF], [scene], [node], [mesh], [primitive], [attributes],
    [accessor], [sparse], [bufferView] and [buffer]. *)

val required : string -> bool
(** [required name] is true if a file that cannot be read without this extension can be read. *)

val quantization : string
(** The extension by which positions may be integers of 1 or 2 bytes. *)
