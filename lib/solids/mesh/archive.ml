open Scc_base
open Text

type part = { name : string; flags : int; how : int; sum : int; packed : int; size : int; at : int }
type t = { path : string; text : string; parts : (string, part) Hashtbl.t }

let u16 text i = Bytes_of.unsigned ~big_endian:false text i 2
let u32 text i = Bytes_of.unsigned ~big_endian:false text i 4

(* {1 The directory} *)

let end_mark = 0x06054B50
let part_mark = 0x02014B50
let local_mark = 0x04034B50

(* The last record of the file, which a comment of at most 65 535 bytes follows. *)
let directory_end text =
  let n = String.length text in
  let rec go i =
    if i < 0 || i < n - 22 - 0xFFFF then None
    else if u32 text i = end_mark && i + 22 + u16 text (i + 20) = n then Some i
    else go (i - 1)
  in
  go (n - 22)

(* Numbers that do not fit into four bytes, or may not, are in an extra field of eight each, in their order. *)
let wide ~path text i ~stop numbers =
  let full n = n = 0xFFFFFFFF in
  let rec field i =
    if i + 4 > stop then None else if u16 text i = 1 then Some (i + 4) else field (i + 4 + u16 text (i + 2))
  in
  let rec take i = function
    | [] -> Ok []
    | n :: rest when not (full n) -> Result.map (fun rest -> n :: rest) (take i rest)
    | _ :: _ when i + 8 > stop -> error_at ~path i "a number of a ZIP64 entry is missing"
    | _ :: _ when u32 text (i + 4) <> 0 -> error_at ~path i "an entry of the ZIP file is larger than all of it"
    | _ :: rest -> Result.map (fun rest -> u32 text i :: rest) (take (i + 8) rest)
  in
  match field i with
  | Some i when List.exists full numbers -> take i numbers
  | Some _ | None -> Ok numbers

let part ~path text i =
  let n = String.length text in
  if i + 46 > n || u32 text i <> part_mark then
    error_at ~path (min i n) "the directory of the ZIP file has fewer entries than it promises"
  else
    let name = u16 text (i + 28) and extra = u16 text (i + 30) and comment = u16 text (i + 32) in
    let next = i + 46 + name + extra + comment in
    if next > n then error_at ~path i "the file ends within an entry of the directory of the ZIP file"
    else
      let numbers = [ u32 text (i + 24); u32 text (i + 20); u32 text (i + 42) ] in
      let* numbers = wide ~path text (i + 46 + name) ~stop:(i + 46 + name + extra) numbers in
      match numbers with
      | [ size; packed; at ] ->
        let name = String.sub text (i + 46) name in
        let flags = u16 text (i + 8) and how = u16 text (i + 10) and sum = u32 text (i + 16) in
        Ok ({ name; flags; how; sum; packed; size; at }, next)
      | _ -> Bug.fail __POS__ "three numbers of an entry are not three"

let read ~path text =
  match directory_end text with
  | None -> error_at ~path 0 "this is no ZIP file: its directory is not found"
  | Some i ->
    let count = u16 text (i + 10) and start = u32 text (i + 16) in
    if count = 0xFFFF || start = 0xFFFFFFFF then error_at ~path i "a ZIP64 directory is not read"
    else if u16 text (i + 4) <> 0 || u16 text (i + 8) <> count then
      error_at ~path i "a ZIP archive of several files is not read"
    else
      let parts = Hashtbl.create 16 in
      let rec go k i =
        if k = 0 then Ok { path; text; parts }
        else
          let* part, next = part ~path text i in
          Hashtbl.add parts (String.lowercase_ascii part.name) part;
          go (k - 1) next
      in
      go count start

(* {1 Contents} *)

let inflate t part ~start =
  let out = Bytes.create part.size in
  let stream = Zlib.inflate_init false in
  let fault why = error_at ~path:t.path part.at "%s cannot be decompressed: %s" (quote part.name) why in
  let rec feed i left written =
    if written = part.size && left = 0 then Ok (Bytes.unsafe_to_string out)
    else
      let ended, used, got =
        Zlib.inflate_string stream t.text i left out written (part.size - written) Zlib.Z_SYNC_FLUSH
      in
      if ended && written + got = part.size then Ok (Bytes.unsafe_to_string out)
      else if ended then fault "it is shorter than the directory says"
      else if used = 0 && got = 0 then fault "it does not end where the directory says"
      else feed (i + used) (left - used) (written + got)
  in
  Fun.protect
    ~finally:(fun () -> Zlib.inflate_end stream)
    (fun () ->
       match feed start part.packed 0 with
       | result -> result
       | exception Zlib.Error (_, why) -> fault (if String.equal why "" then "faulty data" else why))

let most part = min (1 lsl 29) ((1 lsl 20) + (100 * part.packed))

let contents t part =
  let n = String.length t.text in
  let fail fmt = error_at ~path:t.path (min n part.at) fmt in
  let name = quote part.name in
  if part.at + 30 > n || u32 t.text part.at <> local_mark then fail "%s is not where the directory says" name
  else
    let start = part.at + 30 + u16 t.text (part.at + 26) + u16 t.text (part.at + 28) in
    if part.flags land 1 <> 0 then fail "%s is encrypted" name
    else if start + part.packed > n then fail "%s ends after the file" name
    else if part.size > most part then
      fail "%s would take %d bytes, which are %d in the file: that is too much" name part.size part.packed
    else
      let* text =
        match part.how with
        | 0 when part.size = part.packed -> Ok (String.sub t.text start part.size)
        | 0 -> fail "%s has another length than the directory says" name
        | 8 -> inflate t part ~start
        | how -> fail "%s is compressed by a method that is not read, %d" name how
      in
      let sum = Int32.to_int (Zlib.update_crc_string 0l text 0 (String.length text)) land 0xFFFFFFFF in
      if sum = part.sum then Ok text else fail "%s is damaged: its checksum is another one" name

let find t name =
  match Hashtbl.find_all t.parts (String.lowercase_ascii name) with
  | [] -> Ok None
  | [ part ] -> Result.map Option.some (contents t part)
  | part :: _ -> error_at ~path:t.path (min (String.length t.text) part.at) "%s is there twice" (quote part.name)
