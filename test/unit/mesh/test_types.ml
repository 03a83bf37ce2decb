(* Types of fields of prototypes: what is none, values that are not of a type, and connections of two types. *)
open Scc_mesh

let wrl text = "#VRML V2.0 utf8\n" ^ text
let x3d text = "<X3D><Scene>" ^ text ^ "</Scene></X3D>"

let files path =
  let extern name file = Printf.sprintf "EXTERNPROTO %s [ ] \"%s\"\n" name file in
  match path with
  | "a.wrl" -> Ok (wrl (extern "Q" "b.wrl#Q" ^ "PROTO P [ ] { Group { children Q { } } }"))
  | "b.wrl" -> Ok (wrl (extern "P" "a.wrl#P" ^ "PROTO Q [ ] { Group { children P { } } }"))
  | _ -> Error "it is not there"

(* What stands at the fault, and its words. *)
let told path text =
  match Mesh.read ~files ~path text with
  | Ok _ -> "it is read"
  | Error d ->
    let source = if String.equal d.span.file path then text else Result.get_ok (files d.span.file) in
    Printf.sprintf "`%s`: %s" (String.sub source d.span.start (d.span.stop - d.span.start)) d.message

let check path wrap (text, expected) =
  let test () =
    let found = told path (wrap text) in
    let fits = String.starts_with ~prefix:expected found in
    Alcotest.(check string) text expected (if fits then expected else found)
  in
  Alcotest.test_case text `Quick test

let sized kind default body = Printf.sprintf "PROTO P [ exposedField %s s %s ] { %s } P { }" kind default body
let box = "Shape { geometry Box { size IS s } }"

let vrml =
  [
    (sized "SFVec3f" "1 1 1" box, "it is read");
    (sized "SFVec3d" "1 1 1" box, "it is read");
    (sized "Nonsense" "1" "Group { }", "`Nonsense`: `Nonsense` is no type of a field, such as");
    (sized "SFvec3f" "1 1 1" box, "`SFvec3f`: `SFvec3f` is no type of a field; SFVec3f is one");
    (sized "SFVec3f" "TRUE" box, "`TRUE`: `s` is of the type SFVec3f: expected a number, found `TRUE`");
    (sized "SFVec3f" "1 1" "Group { }" ^ " P { s 1 1 1 }", "`s`: `s` is of the type SFVec3f: expected 3 words");
    (sized "SFVec3f" "" box, "`s`: the field `s` of the prototype has no value");
    (sized "MFVec3f" "[ 1 1 1, 2 ]" "Group { }", "`s`: `s` is of the type MFVec3f: expected groups of 3 words");
    (sized "SFColor" "1 1 1" box, "`s`: `size` is of the type SFVec3f, and `s` of the prototype");
    (sized "MFVec3f" "[ 1 1 1 ]" box, "`s`: `size` is of the type SFVec3f, and `s` of the prototype");
    (sized "SFNode" "1" "Group { }", "`1`: `s` is of the type SFNode: expected a node");
    (sized "SFFloat" "Box { }" "Group { }", "`Box`: `s` is of the type SFFloat, and here is a node");
    (sized "SFString" "1" "Group { }", "`1`: `s` is of the type SFString: expected a string");
    (sized "SFBool" "1" "Group { }", "`1`: `s` is of the type SFBool: expected TRUE or FALSE");
    (sized "SFInt32" "1.5" "Group { }", "`1.5`: `s` is of the type SFInt32: expected an integer");
    (sized "SFImage" "1 1 1 0xFF" box, "`s`: `size` is of the type SFVec3f, and `s` of the prototype");
    (sized "SFVec3f" "1 1 1" box ^ " P { s 1 2 }", "`s`: `s` is of the type SFVec3f: expected 3 words, found 2");
    ("PROTO Q [ field SFVec3f t 1 1 1 ] { Group { } } " ^ sized "SFColor" "1 1 1" "Q { t IS s }",
     "`s`: `t` is of the type SFVec3f, and `s` of the prototype is of the type SFColor");
    ("EXTERNPROTO P [ field Nonsense s ] \"a.wrl\"", "`Nonsense`: `Nonsense` is no type");
    (box, "`IS`: `IS` connects a field of a node to one of the prototype around it");
    (sized "SFVec3f" "1 1 1" "Transform { set_translation IS s }",
     "`set_translation`: `set_translation` is an event");
    ("EXTERNPROTO P [ ] \"a.wrl#P\" P { }", "`\"a.wrl#P\"`: the prototype `P` uses itself, by way of"); ]

let declared ?(value = "") ?(access = "inputOutput") kind =
  Printf.sprintf
    "<ProtoDeclare name='P'><ProtoInterface><field name='s' type='%s' accessType='%s' %s/></ProtoInterface>\
     <ProtoBody><Shape><Box><IS><connect nodeField='size' protoField='s'/></IS></Box></Shape></ProtoBody>\
     </ProtoDeclare><ProtoInstance name='P'/>"
    kind access value

let xml =
  [
    (declared ~value:"value='1 1 1'" "SFVec3f", "it is read");
    (declared "Nonsense", "`Nonsense`: `Nonsense` is no type of a field");
    (declared ~access:"whatever" "SFVec3f", "`whatever`: `whatever` is no access of a field");
    (declared ~value:"value='1 1'" "SFVec3f", "`s`: `s` is of the type SFVec3f: expected 3 words, found 2");
    (declared ~value:"value='1 1 1'" "SFColor", "`s`: `size` is of the type SFVec3f, and");
    ("<Shape><Box><IS><connect nodeField='size' protoField='s'/></IS></Box></Shape>",
     "`IS`: `IS` connects a field of a node to one of the prototype");
  ]

let suite =
  ( "types",
    [ ("VRML", List.map (check "t.wrl" wrl) vrml); ("X3D", List.map (check "t.x3d" x3d) xml) ] )
