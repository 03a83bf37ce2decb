(** The tetrahedron of the tests as glTF, whole and with faults. *)

val points : float list array
val corners : int list list

val float32 : (Buffer.t -> int32 -> unit) -> Buffer.t -> float -> unit
(** By a function of [Buffer] that adds four bytes. *)

val gltf_data : string
(** The data of the solid. *)

val gltf_json :
  ?data:string ->
  ?uri:bool ->
  ?head:string ->
  ?node:string ->
  ?sparse:string ->
  ?count:int ->
  ?mode:string ->
  ?root:int ->
  ?more:string ->
  unit ->
  string
(** The solid as glTF, with what is to be added to the file, to its node, and so on. *)

val files : (string * string * string) list
(** Name of the test, path, and text; vertices are numbered as they are met. *)

val in_glb : string
(** The JSON of a GLB file, for {!packed}. *)

val packed : string -> string
(** With the data of the solid, as GLB. *)

val mirrored : string
(** The same solid behind a node that mirrors. *)

val bad : (string * string * string * string) list
(** The same with the place of the fault in the file, and its code. *)
