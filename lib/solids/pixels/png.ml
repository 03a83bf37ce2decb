let signature = "\137PNG\r\n\026\n"
let is text = String.length text >= 8 && String.equal (String.sub text 0 8) signature

exception Bad of string

let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format

(* {1 Chunks} *)

let word text i = Int32.to_int (String.get_int32_be text i) land 0xffffffff

(* A picture cannot be read without the chunks whose names begin with a capital letter. *)
let is_critical kind = kind.[0] >= 'A' && kind.[0] <= 'Z'
let known = [ "IHDR"; "PLTE"; "IDAT"; "IEND" ]

(* Those of one kind after the other, up to the end of the picture. *)
let chunks text =
  let n = String.length text in
  let rec go i found =
    if i + 12 > n then bad "ends too early"
    else
      let length = word text i and kind = String.sub text (i + 4) 4 in
      if length > n - i - 12 then bad "ends within the chunk %S" kind
      else
        let crc = Int32.to_int (Zlib.update_crc_string 0l text (i + 4) (length + 4)) land 0xffffffff in
        if crc <> word text (i + 8 + length) then bad "has a wrong checksum in the chunk %S" kind
        else
          let found = (kind, (i + 8, length)) :: found in
          let stop = i + 12 + length in
          if String.equal kind "IEND" then
            if stop < n then bad "has %s after its end" (Scc_base.Plural.count (n - stop) "byte" "bytes")
            else List.rev found
          else if is_critical kind && not (List.mem kind known) then bad "has the unknown critical chunk %S" kind
          else go (i + 12 + length) found
  in
  go 8 []

type header = { width : int; height : int; depth : int; kind : int; interlaced : bool }

let channels h = match h.kind with 0 | 3 -> 1 | 2 -> 3 | 4 -> 2 | _ -> 4

let header text = function
  | ("IHDR", (i, 13)) :: _ ->
    let byte k = Char.code text.[i + k] in
    let h =
      { width = word text i; height = word text (i + 4); depth = byte 8; kind = byte 9; interlaced = byte 12 = 1 }
    in
    let allowed =
      match h.kind with
      | 0 -> [ 1; 2; 4; 8; 16 ]
      | 3 -> [ 1; 2; 4; 8 ]
      | 2 | 4 | 6 -> [ 8; 16 ]
      | _ -> []
    in
    if not (List.mem h.depth allowed) then bad "has no such type of colours: %d with %d bits" h.kind h.depth;
    if byte 10 <> 0 || byte 11 <> 0 || byte 12 > 1 then bad "has an unknown compression, filter or interlacing";
    h
  | _ -> bad "does not begin with its header"

(* {1 Rows} *)

(* Of each pass of the picture: the first column and row, and the steps to the next ones. *)
let passes h =
  if h.interlaced then
    [ (0, 0, 8, 8); (4, 0, 8, 8); (0, 4, 4, 8); (2, 0, 4, 4); (0, 2, 2, 4); (1, 0, 2, 2); (0, 1, 1, 2) ]
  else [ (0, 0, 1, 1) ]

let count first step all = if all <= first then 0 else ((all - first - 1) / step) + 1
let row_bytes h columns = ((columns * channels h * h.depth) + 7) / 8

let size h (x, y, dx, dy) =
  let columns = count x dx h.width and rows = count y dy h.height in
  if columns = 0 then 0 else rows * (1 + row_bytes h columns)

(* Inflates all IDAT chunks to as many bytes as there have to be. *)
let inflate text found expected =
  let size = expected in
  let expected = expected + 1 in
  let out = Bytes.create expected in
  let stream = Zlib.inflate_init true in
  let written = ref 0 and finished = ref false in
  let rec feed (i, length) =
    if length > 0 && (not !finished) && !written < expected then begin
      let ended, used, got =
        Zlib.inflate_string stream text i length out !written (expected - !written) Zlib.Z_SYNC_FLUSH
      in
      written := !written + got;
      finished := ended;
      if used = 0 && got = 0 && not ended then bad "has compressed data that do not go on";
      feed (i + used, length - used)
    end
  in
  Fun.protect
    ~finally:(fun () -> Zlib.inflate_end stream)
    (fun () ->
       try List.iter (fun (kind, part) -> if String.equal kind "IDAT" then feed part) found
       with Zlib.Error (_, why) ->
         bad "cannot be decompressed: %s" (if String.equal why "" then "faulty data" else why));
  if !written < size then bad "has fewer rows than its header says";
  if !written > size then bad "has more rows than its header says";
  out

let paeth a b c =
  let p = a + b - c in
  let pa = abs (p - a) and pb = abs (p - b) and pc = abs (p - c) in
  if pa <= pb && pa <= pc then a else if pb <= pc then b else c

(* Undoes the filter of the row of [n] bytes after its filter's byte at [at], whose predecessor is at [above] (with
   the row's bytes beginning there), or -1. *)
let unfilter data ~at ~above ~n ~step =
  let get i = Bytes.get_uint8 data i in
  let filter = get at in
  let start = at + 1 in
  for k = 0 to n - 1 do
    let left = if k >= step then get (start + k - step) else 0 in
    let up = if above >= 0 then get (above + k) else 0 in
    let corner = if k >= step && above >= 0 then get (above + k - step) else 0 in
    let predicted =
      match filter with
      | 0 -> 0
      | 1 -> left
      | 2 -> up
      | 3 -> (left + up) / 2
      | 4 -> paeth left up corner
      | f -> bad "has a row with the unknown filter %d" f
    in
    Bytes.set_uint8 data (start + k) ((get (start + k) + predicted) land 255)
  done

(* {1 Pixels} *)

let part text found (name : string) = Option.map (fun (i, n) -> String.sub text i n) (List.assoc_opt name found) 

(* The sample of the bytes from [start] on: its bits as they are. *)
let sample h data start k =
  match h.depth with
  | 16 -> Bytes.get_uint16_be data (start + (2 * k))
  | 8 -> Bytes.get_uint8 data (start + k)
  | d ->
    let bit = k * d in
    (Bytes.get_uint8 data (start + (bit / 8)) lsr (8 - d - (bit land 7))) land ((1 lsl d) - 1)

let level h n = match h.depth with 16 -> n lsr 8 | 8 -> n | d -> n * 255 / ((1 lsl d) - 1)

(* Colour and opacity of a pixel, whose samples [at] gives. *)
let pixel h ~palette ~transparent at =
  let grey n = (n lsl 16) lor (n lsl 8) lor n in
  let alpha_of samples =
    match transparent with
    | Some t when String.length t >= 2 * List.length samples ->
      if List.for_all Fun.id (List.mapi (fun i s -> String.get_uint16_be t (2 * i) = s) samples) then 0 else 255
    | _ -> 255
  in
  let rgb () = (level h (at 0) lsl 16) lor (level h (at 1) lsl 8) lor level h (at 2) in
  match h.kind with
  | 0 -> (grey (level h (at 0)), alpha_of [ at 0 ])
  | 2 -> (rgb (), alpha_of [ at 0; at 1; at 2 ])
  | 4 -> (grey (level h (at 0)), level h (at 1))
  | 6 -> (rgb (), level h (at 3))
  | _ -> (
      let n = at 0 in
      match palette with
      | Some p when String.length p >= 3 * (n + 1) ->
        let alpha = match transparent with Some t when String.length t > n -> Char.code t.[n] | _ -> 255 in
        let byte k = Char.code p.[(3 * n) + k] in
        ((byte 0 lsl 16) lor (byte 1 lsl 8) lor byte 2, alpha)
      | _ -> bad "has a pixel of the colour %d, which its palette does not have" n)

let picture ~path text =
  let found = chunks text in
  let h = header text found in
  let* () = Picture_fault.check_size ~path ~width:h.width ~height:h.height () in
  let palette = part text found "PLTE" and transparent = part text found "tRNS" in
  let data = inflate text found (List.fold_left (fun n p -> n + size h p) 0 (passes h)) in
  let r = Raster.create ~width:h.width ~height:h.height in
  let step = max 1 (channels h * h.depth / 8) in
  let pass at (x, y, dx, dy) =
    let columns = count x dx h.width in
    let rows = if columns = 0 then 0 else count y dy h.height in
    let n = row_bytes h columns in
    for row = 0 to rows - 1 do
      let start = at + (row * (n + 1)) in
      unfilter data ~at:start ~above:(if row = 0 then -1 else start - n) ~n ~step;
      for column = 0 to columns - 1 do
        let sample k = sample h data (start + 1) ((column * channels h) + k) in
        let colour, alpha = pixel h ~palette ~transparent sample in
        let i = ((y + (row * dy)) * h.width) + x + (column * dx) in
        r.colours.(i) <- colour;
        Bytes.set_uint8 r.alphas i alpha
      done
    done;
    at + (rows * (n + 1))
  in
  ignore (List.fold_left pass 0 (passes h));
  Ok r

(* The size comes first in the file: it is looked at before anything else, checksums included. *)
let read ~path text =
  match
    let* () =
      if String.length text >= 24 && String.equal (String.sub text 12 4) "IHDR" then
        Picture_fault.check_size ~path ~width:(word text 16) ~height:(word text 20) ()
      else Ok ()
    in
    picture ~path text
  with
  | result -> result
  | exception Bad why -> Picture_fault.malformed ~path "the PNG file %s" why
