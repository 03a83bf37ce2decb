let is text = String.length text > 2 && text.[0] = 'P' && text.[1] >= '1' && text.[1] <= '6'

exception Bad of string

(* Numbers of the header, and of plain files: with blanks between them, and comments to the end of the line. *)
let rec skip text i =
  if i >= String.length text then raise (Bad "ends too early")
  else
    match text.[i] with
    | ' ' | '\t' | '\n' | '\r' | '\011' | '\012' -> skip text (i + 1)
    | '#' -> (
        match String.index_from_opt text i '\n' with
        | Some j -> skip text (j + 1)
        | None -> raise (Bad "ends in a comment"))
    | _ -> i

let number text i =
  let start = skip text i in
  let rec go i n =
    if i < String.length text && text.[i] >= '0' && text.[i] <= '9' then
      if n > 99_999_999 then raise (Bad "has a number of too many digits")
      else go (i + 1) ((10 * n) + Char.code text.[i] - 48)
    else (n, i)
  in
  let n, stop = go start 0 in
  if stop = start then raise (Bad (Printf.sprintf "has something else than a number at byte %d" start));
  (n, stop)

let grey level = (level lsl 16) lor (level lsl 8) lor level

(* [sample] is the reader of the next one, given where it is; a picture has one or three for each pixel. *)
let fill (r : Raster.t) ~channels ~greatest sample start =
  let level i =
    let n, next = sample i in
    if n > greatest then raise (Bad (Printf.sprintf "has a sample of %d, more than %d" n greatest));
    (((n * 255) + (greatest / 2)) / greatest, next)
  in
  let position = ref start in
  let next () =
    let n, after = level !position in
    position := after;
    n
  in
  for k = 0 to Array.length r.colours - 1 do
    let first = next () in
    r.colours.(k) <-
      (if channels = 1 then grey first
       else
         let green = next () in
         (first lsl 16) lor (green lsl 8) lor next ())
  done;
  !position

let bits (r : Raster.t) text start =
  let row = (r.width + 7) / 8 in
  if String.length text - start < row * r.height then raise (Bad "ends too early");
  for k = 0 to Array.length r.colours - 1 do
    let x = k mod r.width and y = k / r.width in
    let byte = Char.code text.[start + (y * row) + (x / 8)] in
    r.colours.(k) <- (if byte land (128 lsr (x land 7)) <> 0 then 0 else 0xffffff)
  done;
  start + (row * r.height)

(* A plain bitmap needs no blanks between its digits. *)
let digits (r : Raster.t) text start =
  let position = ref start in
  for k = 0 to Array.length r.colours - 1 do
    let i = skip text !position in
    position := i + 1;
    r.colours.(k) <-
      (match text.[i] with '0' -> 0xffffff | '1' -> 0 | _ -> raise (Bad "has something else than 0 and 1"))
  done;
  !position

(* After the samples there may be blanks and comments. *)
let check_end text i =
  match skip text i with
  | _ -> raise (Bad "has more samples than its header says, or more than one picture")
  | exception Bad _ -> ()

let binary text ~greatest i =
  let byte i = if i < String.length text then Char.code text.[i] else raise (Bad "ends too early") in
  if greatest < 256 then (byte i, i + 1) else ((byte i lsl 8) lor byte (i + 1), i + 2)

let picture ~path text =
  let kind = text.[1] in
  let width, i = number text 2 in
  let height, i = number text i in
  let bitmap = kind = '1' || kind = '4' in
  let greatest, i = if bitmap then (1, i) else number text i in
  let* () = Picture_fault.check_size ~path ~width ~height () in
  if greatest < 1 || greatest > 65535 then raise (Bad "has a greatest sample that is not from 1 to 65535");
  let r = Raster.create ~width ~height in
  Bytes.fill r.alphas 0 (width * height) '\255';
  let channels = if kind = '3' || kind = '6' then 3 else 1 in
  check_end text
    (match kind with
     | '1' -> digits r text i
     | '4' -> bits r text (i + 1)
     | '2' | '3' -> fill r ~channels ~greatest (number text) i
     | _ -> fill r ~channels ~greatest (binary text ~greatest) (i + 1));
  Ok r

let read ~path text =
  match picture ~path text with
  | found -> found
  | exception Bad why -> Picture_fault.malformed ~path "the Netpbm file %s" why
