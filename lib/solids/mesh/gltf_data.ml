open Scc_base
open Scc_exact
open Text
module J = Gltf_json

type t = {
  buffers : (string, Diag.t) result Lazy.t array;  (* those of pictures alone may be in other files *)
  views : J.t array;
  accessors : J.t array;
  budget : int ref;
  quantized : bool;
  mutable odd : string option;
}

let spend t at n =
  if n > !(t.budget) then
    J.fail at "with this the file would have many times the vertices that its size has room for"
  else (
    t.budget := !(t.budget) - n;
    Ok ())

(* What another file has is room for vertices too. *)
let outside ~files ~path ~budget buffer uri =
  match Option.map (Beside.find files ~path) (Percent.decoded_strictly uri) with
  | Some (Ok data) ->
    budget := !budget + (2 * String.length data);
    Ok data
  | Some (Error why) ->
    J.fail buffer "the data are in another file, %s, which cannot be read: %s" (quote uri) why
  | None -> J.fail buffer "the name of the file with the data, %s, is no address" (quote uri)

(* The data of a URI [data:…;base64,…]. *)
let named ~files ~path ~budget buffer uri =
  let n = String.length uri in
  match String.index_opt uri ',' with
  | Some comma when n >= 5 && String.equal (String.sub uri 0 5) "data:" ->
    let kind = String.sub uri 0 comma in
    if not (Filename.check_suffix kind ";base64") then J.fail buffer "the data are not in base64"
    else (
      match Base64.decode ~pad:false (String.sub uri (comma + 1) (n - comma - 1)) with
      | Ok data -> Ok data
      | Error (`Msg _) -> J.fail buffer "the data are not valid base64")
  | Some _ | None -> outside ~files ~path ~budget buffer uri

let buffer ~named ~binary i b =
  let* () = Gltf_table.check ~kind:"buffer" b in
  let* length = Result.bind (J.needed "byteLength" b) J.index in
  let* data =
    match (J.member "uri" b, binary) with
    | None, Some data when i = 0 -> Ok data
    | None, _ -> J.fail b "the buffer has no data"
    | Some uri, _ -> Result.bind (J.text uri) (named b)
  in
  if length > String.length data then
    J.fail b "the buffer promises %d bytes, but there are %d" length (String.length data)
  else Ok (String.sub data 0 length)

let make ~files ~path ~binary ~budget ~quantized root =
  let* buffers = J.items "buffers" root in
  let* views = J.items "bufferViews" root in
  let* accessors = J.items "accessors" root in
  let buffers = Array.mapi (fun i b -> lazy (buffer ~named:(named ~files ~path ~budget) ~binary i b)) buffers in
  Ok { buffers; views; accessors; budget; quantized; odd = None }

let odd t = t.odd

(* {1 Views} *)

type view = { data : string; start : int; length : int; stride : int option; at : J.t }

let view t name =
  let* v, _ = J.nth t.views ~what:"buffer view" name in
  let* () = Gltf_table.check ~kind:"bufferView" v in
  let* named = J.needed "buffer" v in
  let* data, _ = J.nth t.buffers ~what:"buffer" named in
  let* data = Lazy.force data in
  let* start = J.index_or 0 "byteOffset" v in
  let* length = Result.bind (J.needed "byteLength" v) J.index in
  let* stride = Option.fold ~none:(Ok 0) ~some:J.index (J.member "byteStride" v) in
  let* () =
    if Option.is_none (J.member "byteStride" v) || (stride >= 4 && stride <= 252 && stride land 3 = 0) then Ok ()
    else J.fail v "the stride of a view is a multiple of 4 from 4 to 252, and not %d" stride
  in
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

let width holder =
  let* component = J.needed "componentType" holder in
  let* kind = J.index component in
  match width_of kind with
  | None -> J.fail component "indices are of type 5121, 5123 or 5125, not %d" kind
  | Some width -> Ok width

(* Integers one after the other in the view that [holder] names. *)
let integers t holder ~width ~offset ~count =
  let* name = J.needed "bufferView" holder in
  let* v = view t name in
  if Option.is_some v.stride then J.fail v.at "indices follow each other, without a stride"
  else
    let* place = places v ~offset ~count ~width in
    Ok (Array.init count (fun i -> Bytes_of.unsigned ~big_endian:false v.data (place i) width))

let all_below ~below holder found =
  match Array.find_opt (fun i -> i >= below) found with
  | Some i -> J.fail holder "there is an index %d, but only %d vertices" i below
  | None -> Ok ()

(* How a coordinate is read, and how wide it is. Integers that are normalized are parts of the greatest one, and
   the least one counts as the one after it. *)
let coordinate t holder =
  let* component = Result.bind (J.needed "componentType" holder) J.index in
  let* normalized = J.truth "normalized" holder in
  let whole width read most =
    let value data place =
      let n = read ~big_endian:false data place width in
      if normalized then Rat.make (Z.of_int (max n (-most))) (Z.of_int most) else Rat.of_int n
    in
    if t.quantized then Ok (width, fun data place -> Ok (value data place))
    else
      J.fail holder "positions of type %d need the extension KHR_mesh_quantization, which is not named" component
  in
  match component with
  | 5126 when normalized -> J.fail holder "floats (type 5126) are not normalized"
  | 5126 -> Ok (4, fun data place -> Bytes_of.real ~path:"" ~big_endian:false data place 4)
  | 5120 -> whole 1 Bytes_of.signed 127
  | 5121 -> whole 1 Bytes_of.unsigned 255
  | 5122 -> whole 2 Bytes_of.signed 32767
  | 5123 -> whole 2 Bytes_of.unsigned 65535
  | other -> J.fail holder "positions are 32-bit floats (type 5126), not of type %d" other

let points t ~coordinate:(width, read) holder ~offset ~count =
  let* name = J.needed "bufferView" holder in
  let* v = view t name in
  let* place = places v ~offset ~count ~width:(3 * width) in
  let real i k =
    match read v.data (place i + (width * k)) with
    | Ok x -> Ok x
    | Error _ -> J.fail v.at "a coordinate must be a finite number, but one of element %d is not" i
  in
  let point i =
    let* x = real i 0 in
    let* y = real i 1 in
    let* z = real i 2 in
    Ok (Vec.make x y z)
  in
  Result.map Array.of_list (Result.all point (List.init count Fun.id))

let rec increasing (list : int array) k =
  k + 1 >= Array.length list || (list.(k) < list.(k + 1) && increasing list (k + 1))

(* Values at some places instead of those that are there; [read holder ~offset ~count] reads them. *)
let with_sparse t accessor ~read ~count all =
  match J.member "sparse" accessor with
  | None -> Ok all
  | Some sparse ->
    let* () = Gltf_table.check ~kind:"sparse" sparse in
    let* few = Result.bind (J.needed "count" sparse) J.index in
    let* () = spend t sparse few in
    let* at = J.needed "indices" sparse in
    let* () = Gltf_table.check ~kind:"sparseIndices" at in
    let* offset = J.index_or 0 "byteOffset" at in
    let* width = width at in
    let* places = integers t at ~width ~offset ~count:few in
    let* () = all_below ~below:count at places in
    let* values = J.needed "values" sparse in
    let* () = Gltf_table.check ~kind:"sparseValues" values in
    let* offset = J.index_or 0 "byteOffset" values in
    let* values = read values ~offset ~count:few in
    if not (increasing places 0) then J.fail at "the places of sparse values are to increase"
    else (
      Array.iteri (fun k i -> all.(i) <- values.(k)) places;
      Ok all)

let accessor t name ~kind =
  let* a, _ = J.nth t.accessors ~what:"accessor" name in
  let* () = Gltf_table.check ~kind:"accessor" a in
  let* count = Result.bind (J.needed "count" a) J.index in
  let* () = spend t a count in
  let* written = Result.bind (J.needed "type" a) J.text in
  let* offset = J.index_or 0 "byteOffset" a in
  if not (String.equal written kind) then J.fail a "expected elements of type %s, found %s" kind (quote written)
  else Ok (a, count, offset)

(* By the specification, an accessor without a view is zero. *)
let all_of accessor ~read ~offset ~count ~zero =
  match J.member "bufferView" accessor with
  | Some _ -> read accessor ~offset ~count
  | None -> Ok (Array.make count zero)

(* The bounds that an accessor states are redundant, and many programs round them: they contradict the data if they
   are off by a thousandth of the greatest coordinate. Those of normalized integers are stated in several ways. *)
let check_bounds t a all =
  let size (v : Vec.t) = Rat.max (Rat.abs v.x) (Rat.max (Rat.abs v.y) (Rat.abs v.z)) in
  let greatest = Array.fold_left (fun r v -> Rat.max r (size v)) Rat.zero all in
  let near = Rat.div greatest (Rat.of_int 1000) in
  let one name pick =
    match J.member name a with
    | None -> Ok ()
    | Some stated ->
      let* stated = J.numbers 3 stated in
      let of_data part = Array.fold_left (fun q v -> pick q (part v)) (part all.(0)) all in
      let found = [| of_data (fun (v : Vec.t) -> v.x); of_data (fun v -> v.y); of_data (fun v -> v.z) |] in
      let off p q = Rat.compare (Rat.abs (Rat.sub p q)) near > 0 in
      if Array.exists Fun.id (Array.map2 off found stated) then
        t.odd <- Some (Printf.sprintf "%s: `%s` is not that of the data, and is left out" (J.place a) name);
      Ok ()
  in
  let* normalized = J.truth "normalized" a in
  if normalized || Array.length all = 0 then Ok ()
  else
    let* () = one "min" Rat.min in
    one "max" Rat.max

let positions t name =
  let* a, count, offset = accessor t name ~kind:"VEC3" in
  let* coordinate = coordinate t a in
  let read = points t ~coordinate in
  let* all = all_of a ~read ~offset ~count ~zero:Vec.zero in
  let* all = with_sparse t a ~read ~count all in
  Result.map (fun () -> all) (check_bounds t a all)

let has_data t name =
  let* a, _ = J.nth t.accessors ~what:"accessor" name in
  if Option.is_some (J.member "bufferView" a) then Ok ()
  else J.fail a "its data are compressed (%s), and are not in the file as they are" Gltf_table.draco

let indices t name ~below =
  let* a, count, offset = accessor t name ~kind:"SCALAR" in
  let* width = width a in
  let* _ = J.truth "normalized" a in
  let read = integers t ~width in
  let* all = all_of a ~read ~offset ~count ~zero:0 in
  let* all = with_sparse t a ~read ~count all in
  let* () = all_below ~below a all in
  let most = (1 lsl (8 * width)) - 1 in
  if Array.exists (Int.equal most) all then
    J.fail a "the index %d, the greatest of its type, is not allowed: for some programs it begins a new strip" most
  else Ok all
