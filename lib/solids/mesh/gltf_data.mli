(** Numbers in the buffers of a glTF file (sections 3.6.1 and 3.6.2 of the specification 2.0 of Khronos).
    Buffers are inside the file, as base64 or as the binary chunk, or in files beside it. Views, accessors and
    sparse accessors are supported. *)

open Scc_base
open Scc_exact

type t

val make :
  files:Beside.reader ->
  path:string ->
  binary:string option ->
  budget:int ref ->
  quantized:bool ->
  Gltf_json.t ->
  (t, Diag.t) result
(** [make ~files ~path ~binary ~budget ~quantized root] gives access to the data of a file, where [binary] is
    the binary chunk of
    a GLB file. The budget is the number of elements that may still be read. It bounds the memory that a small
    file can ask for by naming one accessor often. Reading subtracts from it; callers may subtract too. Other files
    add to it. With [quantized], positions may be integers of 1 or 2 bytes (KHR_mesh_quantization). *)

val spend : t -> Gltf_json.t -> int -> (unit, Diag.t) result
(** [spend t v n] subtracts [n] elements from the budget. If fewer are left, it is a fault at the value [v]. *)

val positions : t -> Gltf_json.t -> (Vec.t array, Diag.t) result
(** The points of the accessor whose index the value is: triples of numbers, exactly. *)

val odd : t -> string option
(** What an accessor states about its data that is not so, if there was one among the positions that were read. *)

val has_data : t -> Gltf_json.t -> (unit, Diag.t) result
(** A fault if the accessor whose index the value is has no view, so that its data are compressed elsewhere. *)

val indices : t -> Gltf_json.t -> below:int -> (int array, Diag.t) result
(** [indices t v ~below] are the numbers of the accessor whose index [v] is: integers of 1, 2 or 4 bytes, each
    less than [below]. The greatest integer of its type is a fault, as some programs begin a new strip there. *)
