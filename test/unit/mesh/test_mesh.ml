(* One tetrahedron in every format; files that do not fit their format; and noise. *)
open Scc_base
open Scc_exact
open Scc_geometry
open Scc_mesh
module G = QCheck2.Gen

let read path text = Result.map fst (Mesh.read ~files:Beside.none ~path text)

(* Positions in order, then corners, so that all formats can be compared. *)
let describe (ifs : Polyhedron.ifs) =
  let face (_, f) = String.concat " " (List.map string_of_int (Array.to_list f)) in
  List.map (fun (_, v) -> Vec.to_string v) (Array.to_list ifs.ifs_vertices)
  @ List.map face (Array.to_list ifs.ifs_faces)

let vertices = [ "(0, 0, 0)"; "(5/4, 0, 0)"; "(0, 1, 0)"; "(0, 0, 2)" ]
let faces = [ "0 2 1"; "0 1 3"; "0 3 2"; "1 2 3" ]
let tetrahedron = vertices @ faces

(* {1 Files} *)

let off =
  "OFF\n# a comment\n4 4 6\n0 0 0\n1.25 0 0\n0 1e0 0 # a comment\n0 0 2.\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"

let obj =
  "# a comment\nmtllib x.mtl\no one\nv 0 0 0\nv 1.25 0 0 1\nv 0 1 0 0.5 0.5 0.5\nv 0 0 2\nvt 0 0\nvn 0 0 1\n\
   g all\nusemtl red\ns off\nf 1 3 2\nf 1/1 2/1 4/1\nf -4//1 -1//1 -2//1\nf 2/1/1 3/1/1 \\\n 4/1/1\n"

let ply_data = "0 0 0 7\n1.25 0 0 7\n0 1 0 7\n0 0 2 7\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"

let ply_header format =
  "ply\nformat " ^ format
  ^ " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\n\
     property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"

let ply = ply_header "ascii" ^ ply_data

let vrml =
  "#VRML V2.0 utf8\nDEF Box Transform { translation 0 0 0 children [ Shape {\n geometry IndexedFaceSet {\n\
   coord Coordinate { point [ 0 0 0, 1.25 0 0, 0 1 0, 0 0 2 ] }\n\
   texCoord TextureCoordinate { point [ 0 0 ] }\n\
   coordIndex [ 0 2 1 -1, 0 1 3 -1, 0 3 2 -1, 1 2 3 ] } } ] }\n"

let x3d =
  "<?xml version='1.0'?>\n<!-- <IndexedFaceSet/> --><X3D><Scene><Transform scale='1 1 1'><Shape>\n\
   <IndexedFaceSet coordIndex=\"0 2 1 -1, 0 1 3 -1 0 3 2 -1 1 2 3\" solid='true'>\n\
   <Coordinate point='0 0 0, 1.25 0 0, 0 1 0, 0 0 2'/></IndexedFaceSet></Shape></Transform></Scene></X3D>\n"

(* The same with characters written as references. *)
let referring =
  "<X3D><Scene><Shape><IndexedFaceSet ccw='&#x74;rue'\n\
   coordIndex='0 2 1&#32;&#45;1, 0 1 3 -1&#x2C;0 3 2 -1 1 2 3'>\n\
   <Coordinate point='0 &#45;0 0, 1&#46;25 0 0, 0 1 0, 0&#x20;0&#32;2'/></IndexedFaceSet></Shape></Scene></X3D>\n"

let points = Gltf_files.points
let corners = Gltf_files.corners

let stl =
  let vertex i = "   vertex " ^ String.concat " " (List.map (Printf.sprintf "%.17e") points.(i)) ^ "\n" in
  let facet f =
    " facet normal 0 0 0\n  outer loop\n" ^ String.concat "" (List.map vertex f) ^ "  endloop\n endfacet\n"
  in
  "solid it\n" ^ String.concat "" (List.map facet corners) ^ "endsolid it\n"

let float32 = Gltf_files.float32

let stl_binary count =
  let b = Buffer.create 300 in
  Buffer.add_string b ("solid but binary" ^ String.make 64 ' ');
  Buffer.add_int32_le b (Int32.of_int count);
  let add_point i = List.iter (float32 Buffer.add_int32_le b) points.(i) in
  let facet f =
    List.iter (float32 Buffer.add_int32_le b) [ 0.; 0.; 0. ];
    List.iter add_point f;
    Buffer.add_uint16_le b 0
  in
  List.iter facet corners;
  Buffer.contents b

let ply_binary ~big format =
  let int32, int64 =
    if big then (Buffer.add_int32_be, Buffer.add_int64_be) else (Buffer.add_int32_le, Buffer.add_int64_le)
  in
  let b = Buffer.create 300 in
  Buffer.add_string b (ply_header format);
  let vertex = function
    | [ x; y; z ] ->
      float32 int32 b x;
      float32 int32 b y;
      int64 b (Int64.bits_of_float z);
      Buffer.add_uint8 b 7
    | _ -> Alcotest.fail "a vertex has three coordinates"
  in
  Array.iter vertex points;
  let face f =
    Buffer.add_uint8 b 3;
    List.iter (fun i -> int32 b (Int32.of_int i)) f
  in
  List.iter face corners;
  Buffer.contents b

let xyz = "# a scan\n0 0 0 0 0 -1\n1.25 0 0 255 0 0 text\n\n0 1 0 # the third\n\t0 0 2.\n"

let crlf text = String.concat "\r\n" (String.split_on_char '\n' text)

(* Also after a byte order mark, that binary files have not. *)
let marked ((name, path, text) as file) =
  if String.contains text '\000' then [ file ]
  else [ file; (name ^ ", after a byte order mark", path, "\xEF\xBB\xBF" ^ text) ]

let files =
  [
    ("OFF without its keyword", "t.off", String.sub off 4 (String.length off - 4));
    ("OFF", "t.off", off); ("OFF in capitals", "DIR.x/T.OFF", off); ("OFF, CRLF", "t.off", crlf off);
    ("OFF, counts on the first line", "t.off", "OFF 4 4 0" ^ String.sub off 21 (String.length off - 21));
    ("COFF", "t.off",
     "COFF\n4 4 0\n0 0 0 1 1 1 1\n5/4 0 0 1 1 1 1\n0 1 0\n0 0 2\n3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2\n3 1 2 3");
    ("OBJ", "t.obj", obj); ("OBJ, CRLF", "t.obj", crlf obj); ("PLY", "t.ply", ply); ("VRML", "t.wrl", vrml);
    ("X3D", "t.x3d", x3d); ("PLY, little endian", "t.ply", ply_binary ~big:false "binary_little_endian");
    ("PLY, big endian", "t.ply", ply_binary ~big:true "binary_big_endian");
    ("OFF told by its text", "t", off); ("PLY told by its text", "t", ply); ("VRML told by its text", "t", vrml);
    ("X3D told by its text", "t", x3d); ("X3D with references", "t.x3d", referring);
  ]
  |> List.concat_map marked

(* Vertices of an STL file are numbered as they are met. *)
let stl_files =
  [ ("STL", "t.stl", stl); ("STL, CRLF", "t.stl", crlf stl); ("STL, binary", "t.stl", stl_binary 4) ]
  |> List.concat_map marked
let by_first_use = [ "(0, 0, 0)"; "(0, 1, 0)"; "(5/4, 0, 0)"; "(0, 0, 2)"; "0 1 2"; "0 2 3"; "0 3 1"; "2 1 3" ]

let good expected (name, path, text) =
  let test () =
    match read path text with
    | Error d -> Alcotest.fail d.Diag.message
    | Ok ifs ->
      Alcotest.(check (list string)) "the same" expected (describe ifs);
      Alcotest.(check bool) "accepted" true (Result.is_ok (Polyhedron.of_ifs ifs));
      Alcotest.(check string) "names" "v0 f3" (fst ifs.ifs_vertices.(0) ^ " " ^ fst ifs.ifs_faces.(3))
  in
  Alcotest.test_case name `Quick test

(* Points alone. *)
let cloud (name, text) =
  let test () =
    match read "t.xyz" text with
    | Error d -> Alcotest.fail d.Diag.message
    | Ok set -> Alcotest.(check (list string)) "the points" vertices (describe set)
  in
  Alcotest.test_case name `Quick test

let clouds =
  [
    ("XYZ", xyz); ("XYZ, CRLF", crlf xyz); ("XYZ, after a byte order mark", "\xEF\xBB\xBF" ^ xyz);
    ("XYZ with a count", "4\n" ^ xyz);
  ]

(* What mirrors turns the faces over; the points are the same with another x. *)
let mirrors x path text () =
  match read path text with
  | Error d -> Alcotest.fail d.Diag.message
  | Ok set ->
    let move (_, (v : Vec.t)) = Vec.to_string { v with x = x v.x } in
    let sorted = List.sort String.compare in
    let points = sorted (List.map move (Array.to_list set.ifs_vertices)) in
    Alcotest.(check (list string)) "the points" (sorted vertices) points;
    Alcotest.(check bool) "accepted" true (Result.is_ok (Polyhedron.of_ifs set))

(* {1 Exactness} *)

let first_x path text =
  match read path text with
  | Ok ifs -> (snd ifs.ifs_vertices.(0)).x
  | Error d -> Alcotest.fail d.Diag.message

let test_exact () =
  let check name expected found = Alcotest.(check string) name expected (Rat.to_string found) in
  let off x = "OFF\n1 0 0\n" ^ x ^ " 0 0\n" in
  check "a decimal" "1/10" (first_x "t.off" (off "0.1"));
  check "a leading point" "-1/2" (first_x "t.off" (off "-.5"));
  check "a trailing point" "3" (first_x "t.off" (off "+3."));
  check "both, with an exponent" "1/200" (first_x "t.off" (off ".5e-2"));
  check "an exponent" "1000000000000000000000" (first_x "t.off" (off "1E21"));
  check "a fraction" "22/7" (first_x "t.off" (off "22/7"));
  let tenth = Int32.float_of_bits (Int32.bits_of_float 0.1) in
  let b = Buffer.create 64 in
  Buffer.add_string b
    "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty short y\nproperty char z\n\
     end_header\n";
  float32 Buffer.add_int32_be b tenth;
  Buffer.add_int16_be b (-2);
  Buffer.add_int8 b (-3);
  match read "t.ply" (Buffer.contents b) with
  | Ok ifs ->
    Alcotest.(check string) "binary floats are dyadic" "(13421773/134217728, -2, -3)"
      (Vec.to_string (snd ifs.ifs_vertices.(0)))
  | Error d -> Alcotest.fail d.Diag.message

(* What is written as a decimal is read as the same number, and 1/3 is not written. *)
let decimals =
  let number =
    G.map3
      (fun n twos fives -> Rat.make (Z.of_int n) (Z.mul (Z.pow (Z.of_int 2) twos) (Z.pow (Z.of_int 5) fives)))
      G.int (G.int_bound 300) (G.int_bound 300)
  in
  QCheck2.Test.make ~name:"decimals are exact" ~count:500 ~print:Rat.to_string number (fun q ->
      let third = Rat.div (Rat.add (Rat.mul (Rat.of_int 3) q) Rat.one) (Rat.of_int 3) in
      Option.is_none (Digits.exact third)
      &&
      match Digits.exact q with
      | Some text -> Rat.equal q (first_x "t.off" ("OFF\n1 0 0\n" ^ text ^ " 0 0\n"))
      | None -> false)

(* {1 Files that do not fit} *)

let unlike_fractions =
  let line i = Printf.sprintf "v 1/%d 1/%d 0\n" (1_000_000_007 + (6 * i)) (1_000_000_009 + (6 * i)) in
  String.concat "" (List.init 6000 line)

(* Name, path, text, and where the error is. *)
let bad =
  let v4 = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n" in
  [
    ("nothing", "t.off", "", "1:1 SC0320"); ("blanks only", "t.obj", " \n\n", "1:1 SC0320");
    ("another format", "t.off", "PLY\n", "1:1 SC0320"); ("no counts", "t.off", "OFF\n", "1:1 SC0320");
    ("two numbers for the counts", "t.off", "OFF\n8\n", "2:1 SC0320");
    ("a negative count", "t.off", "OFF\n-4 4 6\n", "2:1 SC0320");
    ("a count that is no number", "t.off", "OFF\n4 x 6\n", "2:3 SC0320");
    ("a huge count", "t.off", "OFF\n999999999 4 6\n" ^ v4, "2:1 SC0320");
    ("a count of many digits", "t.off", "OFF\n" ^ String.make 5000 '9' ^ " 4 6\n" ^ v4, "2:1 SC0320");
    ("fewer faces than promised", "t.off", "OFF\n4 2 6\n" ^ v4 ^ "3 0 1 2\n", "2:1 SC0320");
    ("more faces than promised", "t.off", "OFF\n4 1 6\n" ^ v4 ^ "3 0 1 2\n3 0 2 1\n", "8:1 SC0320");
    ("two coordinates", "t.off", "OFF\n4 2 6\n0 0 0\n1 0\n", "4:1 SC0320");
    ("four coordinates", "t.off", "OFF\n4 2 6\n0 0 0 1\n", "3:7 SC0320");
    ("an index out of range", "t.off", "OFF\n4 1 6\n" ^ v4 ^ "3 0 1 4\n", "7:7 SC0320");
    ("a negative index", "t.off", "OFF\n4 1 6\n" ^ v4 ^ "3 0 -1 2\n", "7:5 SC0320");
    ("a huge index", "t.off", "OFF\n4 1 6\n" ^ v4 ^ "3 0 1 99999999999999999999\n", "7:7 SC0320");
    ("a face of two corners", "t.off", "OFF\n4 1 6\n" ^ v4 ^ "2 0 1\n", "7:1 SC0320");
    ("a face that promises a billion corners", "t.off", "OFF\n4 1 6\n" ^ v4 ^ "999999999 0 1 2\n", "7:1 SC0320");
    ("not a number", "t.off", "OFF\n4 2 6\n0 zero 0\n", "3:3 SC0320");
    ("NaN", "t.off", "OFF\n4 2 6\n0 0 nan\n", "3:5 SC0320"); ("infinity", "t.obj", "v 0 -inf 0\n", "1:5 SC0320");
    ("hexadecimal", "t.obj", "v 0 0x10 0\n", "1:5 SC0320");
    ("a huge exponent", "t.obj", "v 0 1e1000000000 0\n", "1:5 SC0320");
    ("a long number", "t.obj", "v 0 " ^ String.make 10000 '7' ^ " 0\n", "1:5 SC0320");
    ("a zero denominator", "t.obj", "v 0 1/0 0\n", "1:5 SC0320");
    ("a weight", "t.obj", "v 0 0 0 2\n", "1:9 SC0320");
    ("OBJ index zero", "t.obj", "v 0 0 0\nf 0 1 1\n", "2:3 SC0320");
    ("OBJ index past the end", "t.obj", "v 0 0 0\nf 1 1 2\n", "2:7 SC0320");
    ("OBJ relative index before the start", "t.obj", "v 0 0 0\nf 1 1 -2\n", "2:7 SC0320");
    ("an empty OBJ corner", "t.obj", "v 0 0 0\nf 1 1 /1\n", "2:7 SC0320");
    ("an unknown statement", "t.obj", "v 0 0 0\nfrob 1\n", "2:1 SC0320");
    ("a curve", "t.obj", "v 0 0 0\ncurv 0 1 1\n", "2:1 SC0320");
    ("binary bytes", "t.obj", "\x00\x01\xff\xfe\x80\n", "1:1 SC0320");
    ("STL without its end", "t.stl", "solid\nfacet normal 0 0 0\nouter loop\n", "3:1 SC0320");
    ("STL with another word", "t.stl", "solid\nfacets\n", "2:1 SC0320");
    ("STL with two coordinates", "t.stl", "solid\nfacet\nouter loop\nvertex 0 0\n", "4:1 SC0320");
    ("binary STL that lies", "t.stl",
     String.make 80 'x' ^ "\xff\xff\xff\x7f" ^ String.make 50 '\x00', "1:1 SC0320");
    ("binary STL cut short", "t.stl", String.sub (stl_binary 4) 0 200, "1:1 SC0320");
    ("many different denominators", "t.obj", unlike_fractions, "1:1 SC0106");
    ("STL too short", "t.stl", "xyz", "1:1 SC0320");
    ("PLY without a format", "t.ply", "ply\nend_header\n", "1:1 SC0320");
    ("PLY without an end", "t.ply", "ply\nformat ascii 1.0\n", "2:1 SC0320");
    ("PLY with an unknown type", "t.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n", "4:10 SC0320");
    ("PLY that lies", "t.ply", ply_header "binary_little_endian", "4:16 SC0320");
    ("PLY, a short line", "t.ply", ply_header "ascii" ^ "0 0 0\n", "12:5 SC0320");
    ("VRML without a face set", "t.wrl", "#VRML V2.0 utf8\nShape { }", "1:1 SC0320");
    ("VRML without a bracket", "t.wrl", "#VRML V2.0 utf8\nIndexedFaceSet { coordIndex [ 0 1", "2:29 SC0320");
    ("X3D without an end", "t.x3d", "<X3D", "1:2 SC0320"); ("an unknown ending", "t.doc", "x", "1:1 SC0321");
    ("XYZ without points", "t.xyz", "# nothing\n", "1:1 SC0320");
    ("XYZ, two coordinates", "t.xyz", "0 0 0\n1 2\n", "2:1 SC0320");
    ("XYZ, a wrong count", "t.xyz", "3\n0 0 0\n1 2 3\n", "1:1 SC0320");
    ("XYZ, a header", "t.xyz", "0 0 0\nx y z\n", "2:1 SC0320");
    ("XYZ, atoms", "t.xyz", "1\nO 0 0 0\n", "1:1 SC0320");
    ("XYZ, commas", "t.xyz", "0 0 0\n1,2,3\n", "2:1 SC0320");
    ("XYZ, one word", "t.xyz", "points\n", "1:1 SC0320");
    ("X3D, an unknown entity", "t.x3d", "<Scene><IndexedFaceSet coordIndex='0 &dash;1'/></Scene>", "1:38 SC0320");
    ("X3D, no character", "t.x3d", "<Scene><IndexedFaceSet coordIndex='0 &#xD800;'/></Scene>", "1:38 SC0320");
    ("X3D, a reference that does not end", "t.x3d",
     "<Scene><IndexedFaceSet coordIndex='0 & 1'/></Scene>", "1:38 SC0320");
    ("X3D, a number after a reference", "t.x3d",
     "<Scene><Shape><IndexedFaceSet><Coordinate point='&#49; x 0'/></IndexedFaceSet></Shape></Scene>",
     "1:56 SC0320");
    ("VRML without its first line", "t.wrl", "Shape { geometry Box { } }", "1:1 SC0321");
    ("Inventor", "t.wrl", "#Inventor V2.1 ascii\nSeparator { }", "1:1 SC0321");
    ("VRML, compressed", "t.wrl", "\x1F\x8B\b\000", "1:1 SC0321");
    ("VRML 1", "t.wrl", "#VRML V1.0 ascii\nSeparator { }\n", "1:1 SC0321");
    ("after a byte order mark", "t.off", "\xEF\xBB\xBFPLY", "1:1 SC0320");
    ("the plain format of two counts", "t", "4 4\n0 0 0\n", "1:1 SC0321");
    ("binary OFF", "t.off", "OFF BINARY\n", "1:1 SC0321");
    ("OFF of four dimensions", "t.off", "4OFF\n", "1:1 SC0321");
  ]

let bad_case (name, path, text, expected) =
  let test () =
    match read path text with
    | Ok _ -> Alcotest.fail "read"
    | Error d ->
      let line, column = Source.position (Source.make ~name:path text) d.Diag.span.start in
      Alcotest.(check string) d.message expected (Printf.sprintf "%d:%d %s" line column d.code);
      Alcotest.(check string) "in the file" path d.span.file;
      Alcotest.(check bool) "a short message" true (String.length d.message < 200)
  in
  Alcotest.test_case name `Quick test

(* {1 Noise: any answer will do, but no exception} *)

(* Damage is done to the text, and what packs it, if anything does, comes after it. *)
let mangled =
  let as_it_is = List.map (fun (_, path, text) -> (path, Fun.id, text)) in
  let plain = (("", "t.xyz", xyz) :: files) @ stl_files @ Gltf_files.files @ Threemf_files.files in
  let texts =
    as_it_is plain
    @ List.map (fun model -> ("t.3mf", Threemf_files.packed, model)) Threemf_files.models
    @ [ ("t.glb", Gltf_files.packed, Gltf_files.in_glb) ]
  in
  let pieces =
    [
      "-"; "9"; "1e9"; " "; "\n"; "{"; "]"; "<"; "'"; "\x00"; "nan"; "/"; "-1"; "3"; "element face 9\n"; "\xFF";
      "PK"; "\""; ","; ">"; "&";
    ]
  in
  let piece = G.oneofl pieces in
  let change text = function
    | true, at, _, other ->
      let at = at mod (String.length text + 1) in
      String.sub text 0 at ^ other ^ String.sub text at (String.length text - at)
    | false, at, length, _ ->
      let at = at mod (String.length text + 1) in
      let stop = min (String.length text) (at + length) in
      String.sub text 0 at ^ String.sub text stop (String.length text - stop)
  in
  let changes = G.list_size (G.int_range 1 3) (G.quad G.bool (G.int_bound 2000) (G.int_bound 30) piece) in
  let damaged (path, pack, text) changes = (path, pack (List.fold_left change text changes)) in
  G.map2 damaged (G.oneofl texts) changes

let no_exception =
  QCheck2.Test.make ~name:"mangled files" ~count:10000
    ~print:(fun (path, text) -> path ^ ": " ^ String.escaped text)
    mangled
    (fun (path, text) ->
       match read path text with
       | Ok ifs -> String.length (Solid_report.to_text ~name:path (Solid_report.make ifs)) > 0
       | Error d -> String.equal d.Diag.span.file path)

let suite =
  ("mesh",
   [
     ( "formats",
       List.map (good tetrahedron) (files @ Threemf_files.files)
       @ List.map (good by_first_use) (stl_files @ Gltf_files.files) );
     ("clouds", List.map cloud clouds);
     ("mirrors", [
         Alcotest.test_case "of glTF" `Quick (mirrors Fun.id "t.gltf" Gltf_files.mirrored);
         Alcotest.test_case "of 3MF" `Quick (mirrors Rat.neg "t.3mf" Threemf_files.mirrored);
       ]);
     ("exactness", [ Alcotest.test_case "numbers" `Quick test_exact; Scc_test_support.Property.case decimals ]);
     ("bad files", List.map bad_case (bad @ Gltf_files.bad @ Threemf_files.bad));
     ("noise", [ Scc_test_support.Property.case no_exception ]);
   ])
