open Scc_base
open Scc_exact
open Text
module J = Gltf_json

type t = {
  path : string;
  buffers : (string, Diag.t) result Lazy.t array;  (* those of pictures alone may be in other files *)
  views : J.t array;
  accessors : J.t array;
  budget : int ref;
}

let spend t at n =
  if n > !(t.budget) then
    J.fail at "with this the file would have many times the vertices that its size has room for"
  else (
    t.budget := !(t.budget) - n;
    Ok ())

let outside buffer uri =
  J.fail buffer "the data are in another file, %s: make a GLB file of it, or put them inside as base64" (quote uri)

(* The data of a URI [data:…;base64,…]. *)
let inline buffer uri =
  let n = String.length uri in
  match String.index_opt uri ',' with
  | Some comma when n >= 5 && String.equal (String.sub uri 0 5) "data:" ->
    let kind = String.sub uri 0 comma in
    if not (Filename.check_suffix kind ";base64") then J.fail buffer "the data are not in base64"
    else (
      match Base64.decode ~pad:false (String.sub uri (comma + 1) (n - comma - 1)) with
      | Ok data -> Ok data
      | Error (`Msg _) -> J.fail buffer "the data are not valid base64")
  | Some _ | None -> outside buffer uri

let buffer ~binary i b =
  let* length = Result.bind (J.needed "byteLength" b) J.index in
  let* data =
    match (J.member "uri" b, binary) with
    | None, Some data when i = 0 -> Ok data
    | None, _ -> J.fail b "the buffer has no data"
    | Some uri, _ -> Result.bind (J.text uri) (inline b)
  in
  if length > String.length data then
    J.fail b "the buffer promises %d bytes, but there are %d" length (String.length data)
  else Ok (String.sub data 0 length)

let make ~path ~binary ~budget root =
  let* buffers = J.items "buffers" root in
  let* views = J.items "bufferViews" root in
  let* accessors = J.items "accessors" root in
  let buffers = Array.mapi (fun i b -> lazy (buffer ~binary i b)) buffers in
  Ok { path; buffers; views; accessors; budget }

(* {1 Views} *)

type view = { data : string; start : int; length : int; stride : int option; at : J.t }

let view t name =
  let* v, _ = J.nth t.views ~what:"buffer view" name in
  let* named = J.needed "buffer" v in
  let* data, _ = J.nth t.buffers ~what:"buffer" named in
  let* data = Lazy.force data in
  let* start = J.index_or 0 "byteOffset" v in
  let* length = Result.bind (J.needed "byteLength" v) J.index in
  let* stride = J.index_or 0 "byteStride" v in
  if start + length > String.length data then
    J.fail v "the view ends at byte %d of a buffer of %d" (start + length) (String.length data)
  else Ok { data; start; length; stride = (if stride = 0 then None else Some stride); at = v }

(* Where elements begin: so many, of a width, from an offset in a view on. *)
let places view ~offset ~count ~width =
  let stride = Option.value view.stride ~default:width in
  if stride < width then J.fail view.at "elements of %d bytes come every %d bytes" width stride
  else if count > 0 && offset + ((count - 1) * stride) + width > view.length then
    J.fail view.at "%d elements of %d bytes do not fit into its %d bytes" count width view.length
  else Ok (fun i -> view.start + offset + (i * stride))

(* {1 Accessors} *)

let width_of = function
  | 5121 -> Some 1
  | 5123 -> Some 2
  | 5125 -> Some 4
  | _ -> None

let whole t holder ~offset ~count ~below =
  let* component = J.needed "componentType" holder in
  let* kind = J.index component in
  match width_of kind with
  | None -> J.fail component "indices are of type 5121, 5123 or 5125, not %d" kind
  | Some width ->
    let* name = J.needed "bufferView" holder in
    let* v = view t name in
    let* place = places v ~offset ~count ~width in
    let found = Array.init count (fun i -> Bytes_of.unsigned ~big_endian:false v.data (place i) width) in
    (match Array.find_opt (fun i -> i >= below) found with
     | Some i -> J.fail holder "there is an index %d, but only %d vertices" i below
     | None -> Ok found)

let point t v place i =
  let real k =
    match Bytes_of.real ~path:t.path ~big_endian:false v.data (place i + (4 * k)) 4 with
    | Ok x -> Ok x
    | Error _ -> J.fail v.at "a coordinate must be a finite number, but one of element %d is not" i
  in
  let* x = real 0 in
  let* y = real 1 in
  let* z = real 2 in
  Ok (Vec.make x y z)

let points t holder ~offset ~count =
  let* name = J.needed "bufferView" holder in
  let* v = view t name in
  let* place = places v ~offset ~count ~width:12 in
  Result.map Array.of_list (Result.all (point t v place) (List.init count Fun.id))

let with_sparse t accessor ~count all =
  match J.member "sparse" accessor with
  | None -> Ok all
  | Some sparse ->
    let* few = Result.bind (J.needed "count" sparse) J.index in
    let* () = spend t sparse few in
    let* at = J.needed "indices" sparse in
    let* offset = J.index_or 0 "byteOffset" at in
    let* at = whole t at ~offset ~count:few ~below:count in
    let* values = J.needed "values" sparse in
    let* offset = J.index_or 0 "byteOffset" values in
    let* values = points t values ~offset ~count:few in
    Array.iteri (fun k i -> all.(i) <- values.(k)) at;
    Ok all

let accessor t name ~kind =
  let* a, _ = J.nth t.accessors ~what:"accessor" name in
  let* count = Result.bind (J.needed "count" a) J.index in
  let* () = spend t a count in
  let* written = Result.bind (J.needed "type" a) J.text in
  let* offset = J.index_or 0 "byteOffset" a in
  if not (String.equal written kind) then J.fail a "expected elements of type %s, found %s" kind (quote written)
  else Ok (a, count, offset)

let positions t name =
  let* a, count, offset = accessor t name ~kind:"VEC3" in
  let* component = Result.bind (J.needed "componentType" a) J.index in
  if component <> 5126 then J.fail a "positions are 32-bit floats (type 5126), not of type %d" component
  else
    let* all =
      match J.member "bufferView" a with
      | Some _ -> points t a ~offset ~count
      | None -> Ok (Array.make count Vec.zero)
    in
    with_sparse t a ~count all

let indices t name ~below =
  let* a, count, offset = accessor t name ~kind:"SCALAR" in
  if Option.is_some (J.member "sparse" a) then J.fail a "sparse indices of faces are not read"
  else whole t a ~offset ~count ~below
