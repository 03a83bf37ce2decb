(* Scenes that name others beside them. *)
open Scc_base
open Scc_mesh

let head = "#VRML V2.0 utf8\n"
let shape = "Shape { geometry Box { } }"
let inline url = Printf.sprintf "Inline { url \"%s\" }" url

(* Prototypes of a box with its size, and some in other files. *)
let brick = "PROTO Brick [ field SFVec3f s 2 2 2 eventIn SFTime go ] { Shape { geometry Box { size IS s } } }\n"
let extern ?(fields = "") name url = Printf.sprintf "EXTERNPROTO %s [ %s ] [ \"%s\" ]\n" name fields url

let extern_xml ?(fields = "") name url =
  Printf.sprintf "<ExternProtoDeclare name='%s' url='\"%s\"'>%s</ExternProtoDeclare>" name url fields

let size = "field SFVec3f s"
let address = "field MFString u"
let size_xml = "<field name='s'/>"

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
    ("protos.wrl", head ^ brick ^ "PROTO Half [ ] { Brick { s 1 1 1 } }\nBrick { s 8 8 8 }");
    ( "protos.x3d",
      "<Scene><ProtoDeclare name='Brick'><ProtoInterface><field name='s' type='SFVec3f' value='2 2 2'/>\
       </ProtoInterface><ProtoBody><Shape><Box><IS><connect nodeField='size' protoField='s'/></IS></Box></Shape>\
       </ProtoBody></ProtoDeclare></Scene>" );
    ("sub/lib.wrl", head ^ "PROTO In [ field MFString u \"in.wrl\" ] { " ^ "Inline { url IS u } }");
    ("again.wrl", head ^ extern "X" "protos.wrl#Half");
    ("again.x3d", "<Scene>" ^ extern_xml ~fields:size_xml "Y" "protos.x3d#Brick" ^ "</Scene>");
    ("ring.wrl", head ^ extern "A" "chain.wrl#B"); ("chain.wrl", head ^ extern "B" "ring.wrl#A");
    ("needs.wrl", head ^ extern "A" "need.wrl#B" ^ "PROTO C [ ] { A { } } A { }");
    ("need.wrl", head ^ extern "C" "needs.wrl#C" ^ "PROTO B [ ] { C { } } C { }");
    ("mutual.wrl", head ^ extern "A" "mutual2.wrl" ^ "PROTO C [ ] { A { } }");
    ("mutual2.wrl", head ^ "PROTO B [ ] { C { } }" ^ extern "C" "mutual.wrl#C");
    ("mutual3.wrl", head ^ extern "A" "mutual4.wrl" ^ "PROTO C [ ] { A { } }");
    ("mutual4.wrl", head ^ extern "C" "mutual3.wrl#C" ^ "PROTO B [ ] { C { } }");
    ("short.wrl", head ^ "PROTO S [ ] { Shape { geometry Box { size 1 } } }");
    ("short.x3d", "<Scene><ProtoDeclare name='S'><ProtoBody>\n<Shape><Box size='1'/></Shape></ProtoBody>\
                   </ProtoDeclare></Scene>");
    ("late.x3d", "<Scene><ProtoDeclare name='S'><ProtoBody>\n<Shape><Box/></Shape></ProtoBody></Scene>");
    ( "entity.x3d",
      "<Scene><ProtoDeclare name='S'><ProtoBody>\n<Box size='&no;'/></ProtoBody></ProtoDeclare></Scene>" );
    ("balls.wrl", head ^ "PROTO S [ ] { Shape { geometry Sphere { } } }");
    ("mm.x3dv", "#X3D V3.3 utf8\nUNIT length mm 0.001\n" ^ brick);
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

(* [A] is the prototype that the other file has. *)
let of_other ?fields url rest = extern ?fields "A" url ^ rest

let prototypes =
  [
    ("a default", of_other "protos.wrl" "A { }", "6 faces from -1");
    ("a value", of_other ~fields:size "protos.wrl#Brick" "A { s 4 6 6 }", "6 faces from -2");
    ("the second", of_other "protos.wrl#Half" "A { }", "6 faces from -1/2");
    ( "the second address", of_other "http://a.example/b.wrl#Brick\" \"protos.wrl#Brick" "A { }",
      "6 faces from -1" );
    ("twice", of_other ~fields:size "protos.wrl#Brick" "A { } A { s 4 4 4 }", "12 faces from -2");
    ("in the other notation", of_other ~fields:size "protos.x3d#Brick" "A { s 4 4 4 }", "6 faces from -2");
    ( "in the body of another", of_other ~fields:size "protos.wrl" "PROTO B [ ] { A { s 6 6 6 } } B { }",
      "6 faces from -3" );
    ("not used", of_other "none.wrl" shape, "6 faces from -1");
    ("in a third file", of_other "again.wrl#X" "A { }", "6 faces from -1/2");
    ("in a third file, the first", of_other "again.wrl" "A { }", "SC0321 in t.wrl");
    ("in a third file, of X3D", of_other ~fields:size "again.x3d#Y" "A { s 4 4 4 }", "6 faces from -2");
    ("its own Inline", of_other "sub/lib.wrl" "A { }", "6 faces from -1");
    ("an Inline that is given", of_other ~fields:address "sub/lib.wrl" "A { u \"box.wrl\" }", "6 faces from -1");
    ( "an Inline that is not there", of_other ~fields:address "sub/lib.wrl" "A { u \"in.wrl\" }",
      "SC0321 in t.wrl" );
    ("files that use each other", of_other "needs.wrl#C" "A { }", "SC0321 in need.wrl");
    ("one that leads to itself", of_other "ring.wrl#A" "A { }", "SC0321 in chain.wrl");
    ("a body in itself", of_other "mutual.wrl#C" "A { }", "SC0321 in mutual2.wrl");
    ("a body in itself, declared", of_other "mutual3.wrl#C" "A { }", "SC0321 in mutual4.wrl");
    ("no file", of_other "none.wrl" "A { }", "SC0321 in t.wrl");
    ("above", of_other "../protos.wrl" "A { }", "SC0321 in t.wrl");
    ("no address", "EXTERNPROTO A [ ] [ ] A { }", "SC0321 in t.wrl");
    ("another name", of_other "protos.wrl#No" "A { }", "SC0321 in t.wrl");
    ("none in it", of_other "box.wrl" "A { }", "SC0321 in t.wrl");
    ("no scene", of_other "no.wrl" "A { }", "SC0321 in no.wrl");
    ("an unknown field", of_other "protos.wrl" "A { t 1 }", "SC0321 in t.wrl");
    ("an event", of_other ~fields:"eventIn SFTime go" "protos.wrl" "A { go 1 }", "SC0321 in t.wrl");
    ("a fault in a value", of_other ~fields:size "protos.wrl" "A { s 1 }", "SC0320 in t.wrl");
    ("a fault in its body", of_other "short.wrl" "A { }", "SC0320 in short.wrl");
    ("a fault in its body, X3D", of_other "short.x3d" "A { }", "SC0320 in short.x3d");
    ("a fault of its tags", of_other "late.x3d" "A { }", "SC0320 in late.x3d");
    ("a fault of an entity", of_other "entity.x3d" "A { }", "SC0320 in entity.x3d");
    ("nearly", of_other "balls.wrl" "A { }", "SC0323 in balls.wrl");
    ("in another unit", of_other "mm.x3dv" "A { }", "SC0321 in t.wrl");
    ("in the same unit", "UNIT length mm 0.001 " ^ of_other "mm.x3dv" "A { }", "6 faces from -1");
  ]

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

let check_in path head (what, body, expected) =
  let test () =
    let found = told path (head ^ body) in
    let n = String.length expected in
    let ends = String.length found >= n && String.sub found (String.length found - n) n = expected in
    Alcotest.(check string) what expected (if ends then expected else found)
  in
  Alcotest.test_case what `Quick test

let check = check_in "t.wrl" head

(* The same from X3D in XML. *)
let xml_cases =
  let use ?fields url rest = extern_xml ?fields "A" url ^ rest in
  let instance = "<ProtoInstance name='A'/>" in
  [
    ("a default", use "protos.x3d" instance, "6 faces from -1");
    ( "a value",
      use ~fields:size_xml "protos.x3d#Brick"
        "<ProtoInstance name='A'><fieldValue name='s' value='4 4 4'/></ProtoInstance>",
      "6 faces from -2" );
    ("in the other notation", use "protos.wrl#Half" instance, "6 faces from -1/2");
    ("a fault in its body", use "short.x3d" instance, "SC0320 in short.x3d");
    ("no file", use "none.x3d" instance, "SC0321 in t.x3d");
    ("no address", "<ExternProtoDeclare name='A'/>" ^ instance, "SC0321 in t.x3d");
    ("a body in itself", use "mutual3.wrl#C" instance, "SC0321 in mutual4.wrl");
  ]

let check_xml (what, body, expected) = check_in "t.x3d" "" (what, "<Scene>" ^ body ^ "</Scene>", expected)

(* A place in another file is that of the word there. *)
let place () =
  let at name =
    let lib = List.assoc name files in
    match Mesh.read ~files:file ~path:"t.wrl" (head ^ of_other name "A { }") with
    | Error d -> String.sub lib d.span.start (d.span.stop - d.span.start)
    | Ok _ -> "it is read"
  in
  Alcotest.(check (list string)) "words" [ "size"; "size" ] [ at "short.wrl"; at "short.x3d" ]

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

(* Files of prototypes that need each other inside of deep nodes: the depth of all together is bounded. *)
let deep () =
  let again n text = String.concat "" (List.init n (fun _ -> text)) in
  let nested k =
    extern "A" (Printf.sprintf "%d.wrl" (k + 1)) ^ "PROTO P [ ] { " ^ shape ^ " }"
    ^ again 900 "Group { children " ^ "A { }" ^ again 900 "}"
  in
  let files path =
    match int_of_string_opt (Filename.chop_extension path) with
    | Some k when k < 10 -> Ok (head ^ nested k)
    | Some _ | None -> Ok (head ^ "PROTO P [ ] { " ^ shape ^ " }")
  in
  match Mesh.read ~files ~path:"0.wrl" (head ^ nested 0) with
  | Error d -> Alcotest.(check string) "refused" "SC0320 in 1.wrl" (d.code ^ " in " ^ d.span.file)
  | Ok _ -> Alcotest.fail "it is read"

let suite =
  ("inlines",
   [
     ("files", List.map check cases); ("prototypes", List.map check prototypes);
     ("prototypes of X3D", List.map check_xml xml_cases);
     ("place", [ Alcotest.test_case "in another file" `Quick place ]);
     ("many", [ Alcotest.test_case "doubling" `Quick doubling; Alcotest.test_case "deep" `Quick deep ]);
   ])
