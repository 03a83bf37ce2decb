(* What OFF, OBJ, PLY, STL and XYZ may have in a file: each is read, changes nothing, is left out with a warning,
   or is refused at its place. *)
open Scc_base
open Scc_mesh

(* The tetrahedron of the corners (0, 0, 0), (5/4, 0, 0), (0, 1, 0), (0, 0, 2). *)
let corners = [ "0 0 0"; "1.25 0 0"; "0 1 0"; "0 0 2" ]
let faces = [ [ 0; 2; 1 ]; [ 0; 1; 3 ]; [ 0; 3; 2 ]; [ 1; 2; 3 ] ]
let join = String.concat
let lines list = join "" (List.map (fun l -> l ^ "\n") list)
let numbers list = join " " (List.map string_of_int list)
let full = "(0, 0, 0) (5/4, 1, 2) solid"

let outcome path text =
  match Mesh.read ~files:Beside.none ~path text with
  | Ok _ -> Test_scenes.extent path text
  | Error (d : Diag.t) ->
    let line, column = Source.position (Source.make ~name:path text) d.span.start in
    Printf.sprintf "%s %d:%d" d.code line column

let case path (what, text, expected) =
  let test () = Alcotest.(check string) (what ^ "\n" ^ text) expected (outcome path text) in
  Alcotest.test_case what `Quick test

(* {1 OFF} *)

let off ?(head = "OFF") ?(counts = "4 4 6") ?(vertex = "") ?(face = "") ?(more = "") () =
  let vertices = List.map (fun v -> v ^ vertex) corners in
  lines ((head :: counts :: vertices) @ List.map (fun f -> "3 " ^ numbers f ^ face) faces) ^ more

let on_one_line text = String.map (function '\n' -> ' ' | c -> c) text

let rest head vertex = (head ^ vertex, off ~head ~vertex (), full)

let offs =
  [
    rest "COFF" " 255 0 0"; rest "COFF" " .5 .5 .5 1"; rest "COFF" ""; rest "NOFF" " 0 0 1"; rest "STOFF" " 0 1";
    rest "CNOFF" " 0 0 1 255 0 0 255"; rest "NCOFF" " 0 0 1 255 0 0"; rest "STCNOFF" " 0 0 1 1 1 1 1 0 0";
    rest "NCSTOFF" " 0 0 1 1 1 1 0 0";
    ("OFF with colours", off ~vertex:" 1 1 1" (), "SC0320 3:7");
    ("COFF, two numbers", off ~head:"COFF" ~vertex:" 1 1" (), "SC0320 3:7");
    ("COFF, five numbers", off ~head:"COFF" ~vertex:" 1 1 1 1 1" (), "SC0320 3:7");
    ("NOFF, a word", off ~head:"NOFF" ~vertex:" 1 1 x" (), "SC0320 3:11");
    ("NOFF, four numbers", off ~head:"NOFF" ~vertex:" 0 0 1 1" (), "SC0320 3:7");
    ("STOFF, one number", off ~head:"STOFF" ~vertex:" 1" (), "SC0320 3:7");
    ("CCOFF", off ~head:"CCOFF" (), "SC0320 1:1"); ("4OFF", off ~head:"4OFF" ~vertex:" 1" (), "SC0321 1:1");
    ("nOFF", off ~head:"nOFF" ~counts:"3\n4 4 6" (), "SC0321 1:1");
    ("C4nOFF", off ~head:"C4nOFF" (), "SC0321 1:1"); ("OFF BINARY", off ~head:"OFF BINARY" (), "SC0321 1:1");
    ("COFF BINARY", off ~head:"COFF BINARY" (), "SC0321 1:1"); ("no keyword", off ~head:"" (), full);
    ("another keyword", off ~head:"BEZ" (), "SC0320 1:1");
    ("comments", off ~head:"# first\nOFF # head" ~counts:"4 4 6 # counts" ~vertex:"# v" ~face:"# f" (), full);
    ("no edges", off ~counts:"4 4" (), full); ("wrong edges", off ~counts:"4 4 99" (), full);
    ("four counts", off ~counts:"4 4 6 1" (), "SC0320 2:7");
    ("too few vertices", off ~counts:"3 4 6" (), "SC0320 6:1");
    ("too many vertices", off ~counts:"5 4 6" (), "SC0320 7:7");
    ("too few faces", off ~counts:"4 3 6" (), "SC0320 10:1");
    ("too many faces", off ~counts:"4 5 6" (), "SC0320 2:1");
    ("an index of a colour", off ~face:" 7" (), full); ("a colour", off ~face:" 1 0 0" (), full);
    ("a colour with alpha", off ~face:" 1 0 0 .5" (), full);
    ("two numbers after a face", off ~face:" 1 0" (), "SC0320 7:9");
    ("five numbers after a face", off ~face:" 1 0 0 1 1" (), "SC0320 7:9");
    ("a word after a face", off ~face:" red" (), "SC0320 7:9"); ("more lines", off ~more:"1\n" (), "SC0320 11:1");
    ("an edge as a face", off ~counts:"4 5 6" ~more:"2 0 1\n" (), "SC0320 11:1");
    ("too little on one line", "OFF 4 4 6 0 0 0 1 0 0\n", "SC0320 1:21");
    ("on one line", on_one_line (off ()), full);
    ("on one line, with more", on_one_line (off ~more:"1\n" ()), "SC0320 1:70");
    ("on one line, with colours", on_one_line (off ~face:" 1 1 1" ()), "SC0320 1:46");
    ("small letters", off ~head:"off" (), full); ("a great letter", off ~head:"Off" (), full);
    ("small letters of another keyword", off ~head:"coff" (), "SC0320 1:1");
  ]

(* {1 OBJ} *)

let obj ?(first = "") ?(face = fun f -> "f " ^ numbers (List.map succ f)) ?(more = "") () =
  first ^ lines (List.map (fun v -> "v " ^ v) corners @ List.map face faces) ^ more

(* Each statement of the specification, after the solid. *)
let statements =
  let words text = String.split_on_char ' ' text in
  let added code k = (k, obj ~more:(k ^ " 1 2\n") (), code) in
  let still =
    "s usemtl mtllib usemap maplib vt vp mg lod bevel c_interp d_interp shadow_obj trace_obj ctech stech g o"
  in
  let refused =
    "curv curv2 surf parm trim hole scrv sp end con cstype deg bmat step bsp bzp cdc cdp res call csh frob V F"
  in
  List.map (added full) (words still)
  @ List.map (added (full ^ " SC0324")) [ "l"; "p"; "vn" ]
  @ List.map (added "SC0320 9:1") (words refused)

let all_statements () =
  let known = List.filter (fun (k, _, _) -> not (List.mem k [ "frob"; "V"; "F" ])) statements in
  let sorted = List.sort String.compare in
  Alcotest.(check (list string)) "the table"
    (sorted (List.map (fun (k, _, _) -> k) known @ [ "v"; "f"; "fo" ]))
    (sorted (List.map fst Obj.keywords))

let with_more more f = join " " (List.map (fun i -> string_of_int (i + 1) ^ more) f)

let objs =
  [
    ("relative indices", obj ~face:(fun f -> "f " ^ numbers (List.map (fun i -> i - 4) f)) (), full);
    ("faces first",
     lines (List.map (fun f -> "f " ^ numbers (List.map succ f)) faces @ List.map (fun v -> "v " ^ v) corners),
     full);
    ("textures and normals", obj ~first:"vt 0\nvn 0 0 1\n" ~face:(fun f -> "f " ^ with_more "/1/1" f) (), full);
    ("normals alone", obj ~face:(fun f -> "f " ^ with_more "//1" f) ~more:"vn 0 0 nan\n" (), full);
    ("normals that are not there", obj ~face:(fun f -> "f " ^ with_more "//1" f) (), full ^ " SC0324");
  ]
  @ List.map
    (fun more ->
       let face f = "f " ^ with_more more f in
       ("f 1" ^ more, obj ~first:"vt 0 0\nvn 0 0 1\n" ~face (), full ^ " SC0324"))
    [ "/99"; "/0/0"; "/1/99"; "/-9/1"; "//-2" ]
  @ List.map
    (fun more -> ("f 1" ^ more, obj ~face:(fun f -> "f " ^ with_more more f) (), "SC0320 5:3"))
    [ "/abc"; "/1/x"; "/1/1/1"; "/1.5" ]
  @ List.map (fun line -> (line, obj ~more:(line ^ "\n") (), full ^ " SC0324"))
    [ "vn a b c"; "vn 0 0"; "vn"; "vt abc"; "vt 0 0 0 0"; "vt"; "vp x" ]
  @ [
    ("a face outline", obj ~face:(fun f -> "fo " ^ numbers (List.map succ f)) (), full);
    ("continued lines", obj ~face:(fun f -> "f \\\n" ^ with_more " \\\n" f) (), full);
    ("a comment that is continued", obj ~first:"# a \\\nv 9 9 9\n" (), "(0, 0, 0) (9, 9, 9) no solid");
    ("colours",
     "v 0 0 0 1 0 0\nv 1.25 0 0 1 0 0\nv 0 1 0 1 0 0 1\nv 0 0 2 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", full);
    ("a weight", obj ~first:"v 0 0 0 2\n" (), "SC0320 1:9");
    ("five numbers", obj ~first:"v 0 0 0 1 1\n" (), "SC0320 1:1");
    ("two corners", obj ~more:"f 1 2\n" (), "SC0320 9:1"); ("vertex zero", obj ~more:"f 0 1 2\n" (), "SC0320 9:3");
    ("before the first", obj ~more:"f -5 1 2\n" (), "SC0320 9:3");
  ]

(* {1 PLY} *)

let ply ?(format = "ascii 1.0") ?(vertex = "property float x\nproperty float y\nproperty float z")
    ?(face = "property list uchar int vertex_indices") ?(element = "") ?(counts = (4, 4)) data =
  Printf.sprintf "ply\nformat %s\nelement vertex %d\n%s\nelement face %d\n%s\n%send_header\n%s" format (fst counts)
    vertex (snd counts) face element data

let plain = lines (corners @ List.map (fun f -> "3 " ^ numbers f) faces)
let with_vertex more = lines (List.map (fun v -> v ^ more) corners @ List.map (fun f -> "3 " ^ numbers f) faces)
let xyz = "property float x\nproperty float y\nproperty float z"

(* Corners that every type can have: halves are not needed. *)
let whole_corners = [ [ 0; 0; 0 ]; [ 5; 0; 0 ]; [ 0; 1; 0 ]; [ 0; 0; 2 ] ]

let put ~big kind b x =
  let signed8 = Buffer.add_int8 and signed16 = if big then Buffer.add_int16_be else Buffer.add_int16_le in
  let i32 = if big then Buffer.add_int32_be else Buffer.add_int32_le in
  let i64 = if big then Buffer.add_int64_be else Buffer.add_int64_le in
  match kind with
  | "char" | "int8" | "uchar" | "uint8" -> signed8 b x
  | "short" | "int16" | "ushort" | "uint16" -> signed16 b x
  | "int" | "int32" | "uint" | "uint32" -> i32 b (Int32.of_int x)
  | "float" | "float32" -> i32 b (Int32.bits_of_float (float_of_int x))
  | _ -> i64 b (Int64.bits_of_float (float_of_int x))

let binary ~big ~point ~count ~index ?(trailing = "") () =
  let b = Buffer.create 200 in
  List.iter (List.iter (put ~big point b)) whole_corners;
  List.iter (fun f -> put ~big count b 3; List.iter (put ~big index b) f) faces;
  let axis name = Printf.sprintf "property %s %s" point name in
  ply
    ~format:(if big then "binary_big_endian 1.0" else "binary_little_endian 1.0")
    ~vertex:(join "\n" (List.map axis [ "x"; "y"; "z" ]))
    ~face:(Printf.sprintf "property list %s %s vertex_index" count index)
    (Buffer.contents b ^ trailing)

let wholes =
  String.split_on_char ' ' "char uchar short ushort int uint int8 uint8 int16 uint16 int32 uint32"

let reals = [ "float"; "float32"; "double"; "float64" ]

let types =
  let one big =
    let name kind = Printf.sprintf "%s, %s endian" kind (if big then "big" else "little") in
    let five = "(0, 0, 0) (5, 1, 2) solid" in
    List.map
      (fun kind -> ("points of " ^ name kind, binary ~big ~point:kind ~count:"uchar" ~index:"int" (), five))
      (wholes @ reals)
    @ List.map
      (fun kind -> ("lists of " ^ name kind, binary ~big ~point:"float" ~count:kind ~index:kind (), five))
      wholes
    @ [
      ("trailing bytes, " ^ name "", binary ~big ~point:"short" ~count:"uchar" ~index:"int" ~trailing:"abc" (),
       five ^ " SC0324");
    ]
  in
  one false @ one true

let strip list =
  ply ~element:"element tristrips 1\nproperty list int int vertex_indices\n" ~counts:(4, 0)
    (lines (corners @ [ numbers (List.length list :: list) ]))

let returns =
  let header =
    ply ~format:"binary_little_endian 1.0" ~vertex:"property char x\nproperty char y\nproperty char z" ""
  in
  let face f = "\003" ^ join "" (List.map (fun i -> Printf.sprintf "%c\000\000\000" (Char.chr i)) f) in
  String.map (fun c -> if c = '\n' then '\r' else c) header
  ^ "\010\000\000" ^ "\000\000\000" ^ "\000\001\000" ^ "\000\000\002"
  ^ join "" (List.map face [ [ 1; 2; 0 ]; [ 1; 0; 3 ]; [ 1; 3; 2 ]; [ 0; 2; 3 ] ])

let plys =
  [
    ("plain", ply plain, full); ("another name", ply ~face:"property list uchar int vertex_index" plain, full);
    ("other properties", ply ~vertex:(xyz ^ "\nproperty uchar red\nproperty list uchar float more")
       (with_vertex " 255 2 0.5 0.5"), full);
    ("values that are no numbers",
     ply ~vertex:(xyz ^ "\nproperty float nx") (with_vertex " abc"), full ^ " SC0324");
    ("whole values that are none",
     ply ~vertex:(xyz ^ "\nproperty int id") (with_vertex " 1.5"), full ^ " SC0324");
    ("values that are not finite", ply ~vertex:(xyz ^ "\nproperty float nx") (with_vertex " nan"), full);
    ("two formats", ply ~format:"ascii 1.0\nformat ascii 1.0" plain, "SC0320 3:1");
    ("another order", ply ~vertex:"property float z\nproperty float x\nproperty float y"
       (lines ([ "0 0 0"; "0 1.25 0"; "0 0 1"; "2 0 0" ] @ List.map (fun f -> "3 " ^ numbers f) faces)), full);
    ("comments", ply ~element:"comment x\nobj_info num_cols 512\n" plain, full);
    ("edges", ply ~element:"element edge 1\nproperty int vertex1\nproperty int vertex2\n" (plain ^ "0 1\n"),
     full ^ " SC0324");
    ("another element", ply ~element:"element patch 1\nproperty list uchar int corners\n" (plain ^ "3 0 1 2\n"),
     full ^ " SC0324");
    ("materials", ply ~element:"element material 1\nproperty int a\n" (plain ^ "7\n"), full);
    ("a grid", ply ~element:"element range_grid 1\nproperty list uchar int vertex_indices\n" (plain ^ "1 0\n"),
     "SC0320 9:20");
    ("a strip", strip [ 0; 2; 1; 3; 0; 2 ], full);
    ("a strip that turns by a triangle without area", strip [ 0; 2; 1; 3; 3; 0; 2 ],
     "(0, 0, 0) (5/4, 1, 2) no solid");
    ("strips that end", strip [ 0; 2; 1; 3; -1; 0; 1; 3; -1; 0; 3; 2 ], full);
    ("a strip out of range", strip [ 0; 2; 4 ], "SC0320 16:7");
    ("strips without corners", ply ~element:"element tristrips 1\nproperty int a\n" (plain ^ "7\n"),
     "SC0320 9:19");
    ("an element twice", ply ~element:"element face 0\nproperty int a\n" plain, "SC0320 9:9");
    ("a property twice", ply ~vertex:(xyz ^ "\nproperty float x") (with_vertex " 9"), "SC0320 7:1");
    ("corners twice",
     ply ~face:"property list uchar int vertex_indices\nproperty list uchar int vertex_index" plain, "SC0320 9:1");
    ("no corners", ply ~face:"property list uchar int corners" plain, "SC0320 7:14");
    ("no z", ply ~vertex:"property float x\nproperty float y" plain, "SC0320 3:16");
    ("another version", ply ~format:"ascii 2.0" plain, "SC0320 2:14");
    ("more lines", ply (plain ^ "0 0 0\n"), "SC0320 18:1");
    ("lines that end with a return, and data that begin with a line feed", returns, "(0, 0, 0) (10, 1, 2) solid");
    ("a longer line", ply (with_vertex " 7"), "SC0320 10:7");
    ("a longer line of a face", ply (String.trim plain ^ " 7\n"), full ^ " SC0324");
    ("fewer lines", ply ~counts:(4, 5) plain, "SC0320 7:14");
    ("an index that is no integer", ply ~face:"property list uchar float vertex_indices" plain, "SC0320 14:1");
    ("an unknown type", ply ~vertex:"property half x" plain, "SC0320 4:10");
    ("two corners", ply ~counts:(4, 1) (lines (corners @ [ "2 0 1" ])), "SC0320 14:1");
  ]

(* {1 STL} *)

let facet ?(open_ = "facet normal 0 0 0") ?(more = "") f =
  lines
    ([ open_; " outer loop" ]
     @ List.map (fun i -> "  vertex " ^ List.nth corners i) f
     @ [ more ^ " endloop"; "endfacet" ])

let solid ?(name = "") list = "solid" ^ name ^ "\n" ^ join "" list ^ "endsolid" ^ name ^ "\n"
let all = List.map facet faces

let stl_binary ?(bytes = fun _ -> "\000\000") ?(count = 4) ?(trailing = "") ?(head = "") () =
  let b = Buffer.create 300 in
  Buffer.add_string b (head ^ String.make (80 - String.length head) '\000');
  Buffer.add_int32_le b (Int32.of_int count);
  let real x = Buffer.add_int32_le b (Int32.bits_of_float x) in
  let corner i = Scanf.sscanf (List.nth corners i) "%f %f %f" (fun x y z -> List.iter real [ x; y; z ]) in
  List.iteri
    (fun k f ->
       List.iter real [ 0.; 0.; 1. ];
       List.iter corner f;
       Buffer.add_string b (bytes k))
    faces;
  Buffer.contents b ^ trailing

let stls =
  [
    ("one solid", solid all, full); ("a name of words", solid ~name:" a b c" all, full);
    ("two solids", solid [ List.hd all ] ^ solid (List.tl all), full);
    ("a facet without area", solid (facet [ 0; 0; 1 ] :: all), full);
    ("capitals", String.uppercase_ascii (solid all), full); ("on one line", on_one_line (solid all), full);
    ("capitals on one line", on_one_line (String.uppercase_ascii (solid all)), full);
    ("four corners", solid [ facet [ 0; 1; 2; 3 ] ], "SC0320 7:3");
    ("no end", "solid\n" ^ join "" all, "SC0320 29:1"); ("words after it", solid all ^ "more\n", "SC0320 31:1");
    ("colours", stl_binary ~bytes:(fun _ -> "\031\128") (), full);
    ("an index for each", stl_binary ~bytes:(fun k -> String.make 1 (Char.chr k) ^ "\000") (), full);
    ("a colour of all", stl_binary ~head:"COLOR=abcd" (), full);
    ("solid, but binary", stl_binary ~head:"solid" (), full);
    ("data of programs", stl_binary ~bytes:(fun k -> if k = 3 then "\003\000abc" else "\000\000") (), full);
    ("trailing bytes", stl_binary ~trailing:"abc" (), full ^ " SC0324");
    ("more triangles than promised", stl_binary ~count:3 (), "(0, 0, 0) (5/4, 1, 2) no solid SC0324");
    ("fewer triangles than promised", stl_binary ~count:5 (), "SC0320 1:1");
  ]

(* {1 XYZ} *)

let xyz_lines ?(head = "") ?(rest = "") ?(more = "") () =
  head ^ lines (List.map (fun v -> v ^ rest) corners) ^ more

let xyzs =
  let cloud = "(0, 0, 0) (5/4, 1, 2) no solid" in
  [
    ("points", xyz_lines (), cloud); ("colours", xyz_lines ~rest:" 255 0 0" (), cloud);
    ("normals", xyz_lines ~rest:" 0 0 -1" (), cloud); ("a strength", xyz_lines ~rest:" .5" (), cloud);
    ("words", xyz_lines ~rest:" a tree" (), cloud);
    ("not finite, after a point", xyz_lines ~rest:" nan" (), cloud);
    ("comments", xyz_lines ~head:"# a scan\n" ~rest:" # a point" (), cloud);
    ("empty lines", xyz_lines ~head:"\n\n" ~more:"\n" (), cloud); ("a count", xyz_lines ~head:"4\n" (), cloud);
    ("a count, and an empty line", xyz_lines ~head:"4\n\n" (), cloud);
    ("a wrong count", xyz_lines ~head:"5\n" (), "SC0320 1:1");
    ("a count twice", xyz_lines ~head:"4\n4\n" (), "SC0320 2:1");
    ("a head of words", xyz_lines ~head:"x y z\n" (), "SC0320 1:1");
    ("a head after a count", xyz_lines ~head:"4\nX Y Z\n" (), "SC0320 2:1");
    ("atoms", xyz_lines ~more:"C 0 0 0\n" (), "SC0320 5:1");
    ("atoms, with their number", "1\nwater\nO 0 0 0\n", "SC0320 1:1");
    ("two coordinates", xyz_lines ~more:"1 2\n" (), "SC0320 5:1");
    ("commas", xyz_lines ~more:"1,2,3\n" (), "SC0320 5:1");
    ("semicolons", String.map (function ' ' -> ';' | c -> c) (xyz_lines ()), cloud);
    ("semicolons on one line", xyz_lines ~more:"1;2;3\n" (), "(0, 0, 0) (5/4, 2, 3) no solid");
    ("commas on each line", String.map (function ' ' -> ',' | c -> c) (xyz_lines ~head:"4\n" ()), cloud);
    ("commas of decimals", "0,0 0,0 0,0\n1,5 0,0 1\n", "SC0320 1:1");
    ("commas of six numbers", "0,0,0,1,1,1\n", "SC0320 1:1");
    ("commas and semicolons", "0,5;1;2\n", "SC0320 1:1");
    ("a comma after the point", xyz_lines ~rest:" red,green" (), cloud);
    ("hexadecimal", xyz_lines ~more:"0x1 0 0\n" (), "SC0320 5:1");
    ("not finite", xyz_lines ~more:"nan 0 0\n" (), "SC0320 5:1");
    ("infinite", xyz_lines ~more:"0 inf 0\n" (), "SC0320 5:3");
    ("a point above 10^1000", xyz_lines ~more:"1e2000 0 0\n" (), "SC0320 5:1");
    ("faces", xyz_lines ~more:"f 1 2 3\n" (), "SC0320 5:1"); ("nothing", "", "SC0320 1:1");
  ]

let suite =
  ( "plain",
    [
      ("OFF", List.map (case "t.off") offs);
      ("OBJ", Alcotest.test_case "the table" `Quick all_statements :: List.map (case "t.obj") (statements @ objs));
      ("PLY", List.map (case "t.ply") (types @ plys)); ("STL", List.map (case "t.stl") stls);
      ("XYZ", List.map (case "t.xyz") xyzs);
    ] )
