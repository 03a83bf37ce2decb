(* Damaged files of meshes and drawings:

   fuzz COUNT FILE...     each of the files, damaged COUNT times

   The ending of its name is the format: those that scc shape and scc inflate read, and `.model` for the model of
   a 3MF package, which is packed after it was damaged. Half of the damaged PNG files get the checksums of their
   chunks anew. What a mesh names is read beside FILE, every other time damaged too. Each file is read, or is
   refused with a code at a place that is in the file it names, within ten seconds of the processor; the heap
   stays below two gigabytes. The program prints what came of the files and how long the slowest took. Its exit
   code is 1 if a file raised an exception or took longer. *)
open Scc_base

let seconds = 10.
let words = 2_000_000_000 / 8

exception Too_long

(* {1 Damage} *)

let state = Random.State.make [| 1 |]
let below n = Random.State.int state (max 1 n)

let pieces =
  [|
    "-"; "9"; "1e9"; " "; "\n"; "{"; "}"; "["; "]"; "<"; ">"; "'"; "\""; "\x00"; "nan"; "/"; "-1"; "0"; "3";
    "\xFF"; ","; "&"; "&lt;"; "4294967295"; "2147483647"; "1e-300"; "0.5"; "USE G"; "DEF G "; " IS s "; "P { }";
    "PROTO P [ field SFVec3f s 1 1 1 ] {"; "<ProtoInstance name='P'/>"; "#"; "\\"; "null";
    "\xFF\xFF\xFF\x7F"; "99999999999999999999"; "true"; "<g>"; "</g>"; "<!--"; "]]>"; "element face 9\n";
    "property list uchar int x\n";
  |]

let is_digit c = c >= '0' && c <= '9'

(* The first number from a place on: where it begins and ends. *)
let number text at =
  let n = String.length text in
  let rec start i = if i >= n then None else if is_digit text.[i] then Some i else start (i + 1) in
  let rec stop i = if i < n && is_digit text.[i] then stop (i + 1) else i in
  Option.map (fun i -> (i, stop i)) (start at)

let splice text i j middle = String.sub text 0 i ^ middle ^ String.sub text j (String.length text - j)

let change text =
  let n = String.length text in
  let at = below (n + 1) in
  let stop = min n (at + 1 + below 40) in
  match below 20 / 3 with
  | 0 -> splice text at at pieces.(below (Array.length pieces))
  | 1 -> splice text at stop ""
  | 2 -> splice text at (min n (at + 1)) (String.make 1 (Char.chr (below 256)))
  | 3 -> splice text at at (String.sub text at (stop - at))
  | 4 ->
    let other = below (n + 1) in
    splice text other other (String.sub text at (stop - at))
  | 5 | 6 when below 10 = 0 -> String.sub text 0 at
  | _ -> (
      match number text at with
      | Some (i, j) -> splice text i j pieces.(below (Array.length pieces))
      | None -> text)

let rec damaged k text = if k = 0 then text else damaged (k - 1) (change text)

(* {1 Reading} *)

let relations =
  "<Relationships><Relationship Target='/m' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>\
   </Relationships>"

(* A ZIP archive of parts that are not compressed. *)
let packed parts =
  let out = Buffer.create 1000 and directory = Buffer.create 200 in
  let u16 = Buffer.add_uint16_le and u32 b n = Buffer.add_int32_le b (Int32.of_int n) in
  let one (name, text) =
    let at = Buffer.length out and size = String.length text in
    let common b =
      List.iter (u16 b) [ 20; 0; 0; 0; 0 ];
      Buffer.add_int32_le b (Zlib.update_crc_string 0l text 0 size);
      List.iter (u32 b) [ size; size ];
      List.iter (u16 b) [ String.length name; 0 ]
    in
    u32 out 0x04034B50;
    common out;
    Buffer.add_string out (name ^ text);
    u32 directory 0x02014B50;
    u16 directory 20;
    common directory;
    List.iter (u16 directory) [ 0; 0; 0; 0; 0 ];
    u32 directory at;
    Buffer.add_string directory name
  in
  List.iter one parts;
  let start = Buffer.length out and count = List.length parts in
  Buffer.add_buffer out directory;
  u32 out 0x06054B50;
  List.iter (u16 out) [ 0; 0; count; count ];
  List.iter (u32 out) [ Buffer.length directory; start ];
  u16 out 0;
  Buffer.contents out

let contents path =
  let file = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))

(* The files beside it, by what was read of them. *)
let beside read path =
  match List.assoc_opt path !read with
  | Some text -> Ok text
  | None -> (
      match contents path with
      | text ->
        let text = if Random.State.bool state then damaged 1 text else text in
        read := (path, text) :: !read;
        Ok text
      | exception Sys_error why -> Error why)

exception No_place of string

let in_its_file read (d : Diag.t) =
  let s = d.span in
  match List.assoc_opt s.file read with
  | Some text when s.start >= 0 && s.stop <= String.length text + 1 -> ()
  | _ -> raise (No_place (Printf.sprintf "%s: %s from %d to %d" d.code s.file s.start s.stop))

let mesh path text =
  let read = ref [ (path, text) ] in
  let found = Scc_mesh.Mesh.read ~files:(beside read) ~path text in
  List.iter (in_its_file !read) (match found with Ok (_, warnings) -> warnings | Error d -> [ d ]);
  match found with
  | Ok (_, []) -> "read"
  | Ok (_, _ :: _) -> "read with a warning"
  | Error d -> "refused, " ^ d.code

let drawing path text =
  match Scc_pixels.Icon.read ~resolution:32 ~path text with
  | Ok _ -> "read"
  | Error d -> "refused, " ^ d.Diag.code

(* The chunks of a PNG file, as far as their lengths hold, with the right checksums. *)
let summed text =
  let bytes = Bytes.of_string text in
  let n = Bytes.length bytes in
  let rec go at =
    if at + 12 <= n then
      let length = Int32.to_int (Bytes.get_int32_be bytes at) land 0xFFFFFFFF in
      if length <= n - at - 12 then (
        let sum = Zlib.update_crc 0l bytes (at + 4) (length + 4) in
        Bytes.set_int32_be bytes (at + 8 + length) sum;
        go (at + 12 + length))
  in
  go 8;
  Bytes.to_string bytes

let outcome path text =
  match String.lowercase_ascii (Filename.extension path) with
  | ".model" -> mesh "t.3mf" (packed [ ("_rels/.rels", relations); ("m", text) ])
  | ".png" when Random.State.bool state -> drawing path (summed text)
  | ".svg" | ".png" | ".pbm" | ".pgm" | ".ppm" | ".pnm" -> drawing path text
  | _ -> mesh path text

let slowest = ref 0.

let guarded path text =
  let stop = { Unix.it_interval = 0.; it_value = seconds } in
  let start = Sys.time () in
  ignore (Unix.setitimer ITIMER_VIRTUAL stop);
  let found = match outcome path text with found -> Ok found | exception e -> Error (Printexc.to_string e) in
  ignore (Unix.setitimer ITIMER_VIRTUAL { Unix.it_interval = 0.; it_value = 0. });
  slowest := Float.max !slowest (Sys.time () -. start);
  found

(* {1 Counting} *)

let faults = ref 0

let fault path text why =
  incr faults;
  let kept = Printf.sprintf "fault-%d%s" !faults (Filename.extension path) in
  if !faults <= 10 then (
    let file = open_out_bin kept in
    output_string file text;
    close_out file;
    Printf.printf "FAULT: %s: %s (kept as %s)\n%!" path why kept)

let check count path =
  let seed = contents path in
  let found = Hashtbl.create 10 in
  slowest := 0.;
  for _ = 1 to count do
    let text = damaged (1 + below 3) seed in
    match guarded path text with
    | Ok what -> Hashtbl.replace found what (1 + Option.value (Hashtbl.find_opt found what) ~default:0)
    | Error why -> fault path text why
  done;
  let all = List.sort compare (Hashtbl.fold (fun what n all -> (what, n) :: all) found []) in
  let counts = String.concat ", " (List.map (fun (what, n) -> Printf.sprintf "%d %s" n what) all) in
  Printf.printf "%s: %s; the slowest took %.2f s\n%!" (Filename.basename path) counts !slowest;
  if (Gc.quick_stat ()).top_heap_words > words then fault path "" "the heap is beyond two gigabytes"

let () =
  Sys.set_signal Sys.sigvtalrm (Signal_handle (fun _ -> raise Too_long));
  match Array.to_list Sys.argv with
  | _ :: count :: (_ :: _ as files) when Option.is_some (int_of_string_opt count) ->
    List.iter (check (int_of_string count)) files;
    let heap = (Gc.quick_stat ()).top_heap_words * 8 / 1_000_000 in
    Printf.printf "%d faults; the heap was %d MB at most\n" !faults heap;
    exit (min 1 !faults)
  | _ ->
    prerr_endline "usage: fuzz COUNT FILE...";
    exit 64
