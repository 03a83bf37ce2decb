(* Scenes that name others beside them. *)
open Scc_base
open Scc_mesh

let head = "#VRML V2.0 utf8\n"
let shape = "Shape { geometry Box { } }"
let inline url = Printf.sprintf "Inline { url \"%s\" }" url

(* What is beside the scene that is read. *)
let files =
  [
    ("box.wrl", head ^ shape); ("a box.wrl", head ^ shape); ("box.x3d", "<Scene><Shape><Box/></Shape></Scene>");
    ("sub/in.wrl", head ^ inline "deeper/in.wrl"); ("sub/deeper/in.wrl", head ^ shape);
    ("self.wrl", head ^ inline "./self.wrl"); ("one.wrl", head ^ inline "other.x3d");
    ("other.x3d", "<Scene><Inline url='one.wrl'/></Scene>");
    ("bad.wrl", head ^ "Shape { geometry Box { size 1 } }");
    ("no.wrl", "nothing"); ("empty.wrl", head); ("unread.wrl", head ^ "Shape { geometry NurbsSweptSurface { } }");
    ("cm.x3dv", "#X3D V3.3 utf8\nPROFILE Interchange\nUNIT length cm 0.01\n" ^ shape);
    ( "mm.x3d",
      "<X3D><head><unit category='length' name='mm' conversionFactor='1e-3'/></head><Scene><Inline \
       url='cm.x3dv'/></Scene></X3D>" );
    ("km.x3dv", "#X3D V3.3 utf8\nUNIT length km 1000\nUNIT mass t 1000\n" ^ inline "mm.x3d");
    ("round.wrl", head ^ "Shape { geometry Sphere { } }");
  ]

let file path = Option.to_result ~none:"it is not there" (List.assoc_opt path files)

let told path text =
  match Mesh.read ~files:file ~path text with
  | Ok (set, warnings) -> (
      let spans = List.map (fun (d : Diag.t) -> " " ^ d.code ^ " in " ^ d.span.file) warnings in
      let ends = Array.map (fun (_, v) -> v.Scc_exact.Vec.x) set.ifs_vertices in
      match Array.to_list ends with
      | [] -> "nothing"
      | x :: rest ->
        let least = List.fold_left Scc_exact.Rat.min x rest in
        Printf.sprintf "%d faces from %s%s" (Array.length set.ifs_faces) (Scc_exact.Rat.to_string least)
          (String.concat "" spans))
  | Error d -> Printf.sprintf "%s in %s" d.code d.span.file

let cases =
  [
    ("beside it", inline "box.wrl", "6 faces from -1");
    ( "moved", "Transform { translation 5 0 0 children " ^ inline "box.wrl" ^ " }",
      "6 faces from 4" );
    ("twice", inline "box.wrl" ^ inline "./box.wrl", "12 faces from -1");
    ("with a blank", inline "a box.wrl", "6 faces from -1");
    ("with a mark", inline "box.wrl#View", "6 faces from -1");
    ("of the other format", inline "box.x3d", "6 faces from -1");
    ("in folders", inline "sub/in.wrl", "6 faces from -1");
    ("the second", "Inline { url [ \"http://a.example/b.wrl\" \"none.wrl\", \"box.wrl\" ] }", "6 faces from -1");
    ("elsewhere", inline "http://a.example/b.wrl", "SC0321 in t.wrl");
    ("above", inline "../box.wrl", "SC0321 in t.wrl");
    ("not there", inline "none.wrl", "SC0321 in t.wrl"); ("itself", inline "t.wrl", "SC0321 in t.wrl");
    ("inside of itself", inline "self.wrl", "SC0321 in self.wrl");
    ("around", inline "one.wrl", "SC0321 in other.x3d");
    ("a fault in it", inline "bad.wrl", "SC0320 in bad.wrl");
    ("another format", inline "no.wrl", "SC0321 in no.wrl");
    ("what is not read", inline "unread.wrl", "SC0321 in unread.wrl");
    ("nearly", inline "round.wrl" ^ shape, "SC0323 in round.wrl");
    ("not loaded", "Inline { load FALSE url \"box.wrl\" }", "SC0320 in t.wrl");
    ("not visible", "Inline { visible FALSE url \"bad.wrl\" }" ^ shape, "6 faces from -1");
    ("in another unit", inline "cm.x3dv", "6 faces from -1/100");
    ( "in units of units", "Transform { translation 1 0 0 children " ^ inline "mm.x3d" ^ " }",
      "6 faces from 99/100" );
    ("a unit of what is around", "UNIT length mm 0.001 " ^ inline "box.wrl", "6 faces from -1000");
    ("its own unit alone", "UNIT length mm 0.001 " ^ shape, "6 faces from -1");
    ("one unit after the other", "UNIT length mm 0.001 " ^ inline "km.x3dv" ^ shape, "12 faces from -10");
    ("twice a unit", "UNIT length mm 0.001 UNIT length cm 0.01 " ^ shape, "SC0320 in t.wrl");
    ("a unit of 0", "UNIT length mm 0 " ^ shape, "SC0320 in t.wrl");
    ("a negative unit", "UNIT mass kg -1 " ^ shape, "SC0320 in t.wrl");
    ("an unknown unit", "UNIT time s 1 " ^ shape, "SC0320 in t.wrl");
    ("empty", inline "empty.wrl" ^ shape, "6 faces from -1"); ("no url", "Inline { }" ^ shape, "6 faces from -1");
  ]

let check (what, body, expected) =
  let test () =
    let found = told "t.wrl" (head ^ body) in
    let n = String.length expected in
    let ends = String.length found >= n && String.sub found (String.length found - n) n = expected in
    Alcotest.(check string) what expected (if ends then expected else found)
  in
  Alcotest.test_case what `Quick test

(* Files that double each other, ten levels of ten: refused, and soon. *)
let doubling () =
  let many k = head ^ String.concat "" (List.init 10 (fun _ -> inline (Printf.sprintf "%d.wrl" k))) in
  let files path =
    match int_of_string_opt (Filename.chop_extension path) with
    | Some k when k < 10 -> Ok (many (k + 1))
    | Some _ | None -> Ok (head ^ shape)
  in
  match Mesh.read ~files ~path:"0.wrl" (many 1) with
  | Error d -> Alcotest.(check string) "refused" "SC0320" d.code
  | Ok _ -> Alcotest.fail "it is read"

let suite =
  ("inlines", [ ("files", List.map check cases); ("many", [ Alcotest.test_case "doubling" `Quick doubling ]) ])
