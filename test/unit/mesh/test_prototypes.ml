(* Prototypes of VRML and X3D: instances, by hand, in both encodings; bombs and faults. *)
open Scc_base
open Scene_files
open Test_scenes

let vrml text = ("t.wrl", "#VRML V2.0 utf8\n" ^ text)
let xml text = ("t.x3d", "<X3D><Scene>\n" ^ text ^ "</Scene></X3D>")
let lines = String.concat "\n"
let unit_box = "Shape { geometry Box { } }"
let shape inside = "<Shape>" ^ inside ^ "</Shape>"

(* The prototype of a box with its size, and an instance of it with some fields. *)
let brick_vrml rest = vrml ("PROTO Brick [ exposedField SFVec3f s 2 2 2  eventIn SFTime go ] {\n\
                             Shape { geometry Box { size IS s } } Group { } }\n" ^ rest)

let declared fields body =
  "<ProtoDeclare name='Brick'><ProtoInterface>" ^ fields ^ "</ProtoInterface><ProtoBody>" ^ body
  ^ "</ProtoBody></ProtoDeclare>\n"

let connect inner outer = Printf.sprintf "<IS><connect nodeField='%s' protoField='%s'/></IS>" inner outer

let brick_xml rest =
  let fields =
    "<field name='s' type='SFVec3f' accessType='inputOutput' value='2 2 2'/>\
     <field name='go' type='SFTime' accessType='inputOnly'/>"
  in
  xml (declared fields (shape ("<Box>" ^ connect "size" "s" ^ "</Box>") ^ "<Group/>") ^ rest)

let brick_with fields = brick_xml ("<ProtoInstance name='Brick' " ^ fields ^ "</ProtoInstance>")

let holder_vrml =
  "PROTO Holder [ field MFNode c [ ] field SFVec3f at 0 0 0 ] {\n\
   Transform { translation IS at children IS c } }\n"

let places =
  let cube = "(-1, -1, -1) (1, 1, 1) solid" and flat = "(-1, -2, -3) (1, 2, 3) solid" in
  let moved = "(0, -1, -1) (2, 1, 1) solid" in
  [
    ("the default", brick_vrml "Brick { }", cube);
    ("the default, XML", brick_xml "<ProtoInstance name='Brick'/>", cube);
    ("a value", brick_vrml "Brick { s 2 4 6 }", flat);
    ("a value, XML", brick_with "><fieldValue name='s' value='2 4 6'/>", flat);
    ("used again", brick_vrml "Switch { choice DEF B Brick { s 2 4 6 } } USE B", flat);
    ( "used again, XML",
      brick_xml
        "<Switch><ProtoInstance name='Brick' DEF='B'><fieldValue name='s' value='2 4 6'/></ProtoInstance></Switch>\
         <ProtoInstance USE='B'/>", flat );
    ( "used again, XML, with its name",
      brick_xml
        "<Switch><ProtoInstance name='Brick' DEF='B'><fieldValue name='s' value='2 4 6'/></ProtoInstance></Switch>\
         <ProtoInstance name='Brick' USE='B'/>", flat );
    ("nodes", vrml (holder_vrml ^ "Holder { at 1 0 0 c [ " ^ unit_box ^ " ] }"), moved);
    ( "nodes, XML",
      xml
        (declared
           "<field name='c' type='MFNode' accessType='inputOutput'/>\
            <field name='at' type='SFVec3f' accessType='inputOutput' value='0 0 0'/>"
           ("<Transform><IS><connect nodeField='children' protoField='c'/>\
             <connect nodeField='translation' protoField='at'/></IS></Transform>")
         ^ "<ProtoInstance name='Brick'><fieldValue name='at' value='1 0 0'/><fieldValue name='c'>"
         ^ shape "<Box/>" ^ "</fieldValue></ProtoInstance>"), moved );
    ( "one in another",
      vrml
        (lines
           [
             holder_vrml; "PROTO Two [ field SFVec3f p 0 0 0 ] { Holder { at IS p c " ^ unit_box ^ " } }";
             "Two { p 1 0 0 }";
           ]),
      moved );
    ( "a prototype of a material",
      vrml
        (lines
           [
             "PROTO M [ field SFFloat t 0 ] { Material { transparency IS t } }";
             "Shape { geometry Box { } appearance Appearance { material M { t 0.5 } } }";
           ]),
      cube );
    ( "names of its own",
      vrml
        (lines
           [
             "PROTO P [ ] { Group { children [ DEF A " ^ unit_box ^ " Switch { choice USE A } ] } }";
             "Switch { choice DEF A Shape { geometry Cone { } } } P { }";
           ]),
      cube );
    ( "an event of the body",
      vrml
        (lines
           [
             "PROTO P [ eventIn SFVec3f set_t ] {"; "Transform { set_translation IS set_t children";
             unit_box ^ " } }"; "P { }";
           ]),
      cube );
    ( "a route to an instance",
      brick_vrml "DEF B Brick { } DEF T TimeSensor { } ROUTE T.time TO B.go",
      cube ^ " SC0324" );
    ( "a route in the body",
      vrml
        (lines
           [
             "PROTO P [ ] { DEF T Transform { children " ^ unit_box ^ " }";
             "DEF I PositionInterpolator { } ROUTE I.value_changed TO T.translation }"; "P { }";
           ]),
      cube ^ " SC0324" );
  ]

let check_place (what, (path, text), expected) =
  Alcotest.test_case what `Quick (fun () -> Alcotest.(check string) text expected (extent path text))

(* {1 What is refused} *)

let doubling_vrml n =
  let level k = Printf.sprintf "PROTO P%d [ ] { Group { children [ P%d { } P%d { } ] } }\n" (k + 1) k k in
  vrml ("PROTO P0 [ ] { " ^ unit_box ^ " }\n" ^ String.concat "" (List.init n level) ^ Printf.sprintf "P%d { }" n)

let doubling_xml n =
  let proto k body = Printf.sprintf "<ProtoDeclare name='P%d'><ProtoBody>%s</ProtoBody></ProtoDeclare>\n" k body in
  let use k = Printf.sprintf "<ProtoInstance name='P%d'/>" k in
  let level k = proto (k + 1) ("<Group>" ^ use k ^ use k ^ "</Group>") in
  xml (proto 0 (shape "<Box/>") ^ String.concat "" (List.init n level) ^ use n)

let chain n =
  let level k = Printf.sprintf "PROTO P%d [ ] { P%d { } }\n" (k + 1) k in
  vrml ("PROTO P0 [ ] { " ^ unit_box ^ " }\n" ^ String.concat "" (List.init n level) ^ Printf.sprintf "P%d { }" n)

let instance = "<ProtoInstance name='Brick'/>"
let in_value = "<ProtoInstance name='Brick'><fieldValue name='s'>"
let out_of_value = "</fieldValue></ProtoInstance>"
let again n text = String.concat "" (List.init n (fun _ -> text))

let refusals =
  [
    ("an unknown field", brick_vrml "Brick { t 1 }", "SC0321");
    ("an unknown field, XML", brick_with "><fieldValue name='t' value='1'/>",
     "SC0321");
    ("an event with a value", brick_vrml "Brick { go 1 }", "SC0321");
    ("a fault in a value", brick_vrml "Brick { s 1 2 }", "SC0320");
    ("inside of itself", vrml "PROTO P [ ] { Group { children P { } } }\nP { }", "SC0320");
    ("before its declaration", vrml "P { }\nPROTO P [ ] { Group { } }", "SC0321");
    ("a body without nodes", vrml "PROTO P [ ] { }\nP { }", "SC0320");
    ("IS of an unknown field", vrml "PROTO P [ ] { Transform { scale IS s } }\nP { }", "SC0320");
    ( "IS of an unknown field, XML",
      xml (declared "" ("<Transform>" ^ connect "scale" "s" ^ "</Transform>") ^ instance), "SC0320" );
    ( "a shape for a texture, in one instance of two",
      vrml
        ("PROTO P [ field SFNode t NULL ] { Shape { geometry Box { } appearance Appearance { texture IS t } } }\n\
          P { } P { t " ^ unit_box ^ " } P { }"), "SC0320" );
    ("an interface that is none", vrml "PROTO P [ 7 ] { Group { } }", "SC0320");
    ("in another file", vrml "EXTERNPROTO P [ field SFFloat a ] \"p.wrl#P\"\nP { a 1 }", "SC0321");
    ("in another file, XML", xml ("<ExternProtoDeclare name='Brick' url='x.x3d'/>" ^ instance), "SC0321");
    ("no declaration, XML", xml instance, "SC0321");
    ("doubling", doubling_vrml 60, "SC0320"); ("doubling, XML", doubling_xml 60, "SC0320");
    ("a long chain", chain 5000, "SC0320");
    ("deep interfaces", vrml (again 100_000 "PROTO P [ field MFNode f [ Group { } "), "SC0320");
    ("deep instances, XML", brick_xml (again 20_000 in_value), "SC0320");
    ("deep values, XML", brick_xml (again 3000 in_value ^ again 3000 out_of_value), "SC0320");
  ]

let check_refusal (what, (path, text), code) =
  let test () =
    match read path text with
    | Error d -> Alcotest.(check string) what code d.Diag.code
    | Ok _ -> Alcotest.fail (what ^ " is read")
  in
  Alcotest.test_case what `Quick test

let suite =
  ("prototypes", [ ("instances", List.map check_place places); ("faults", List.map check_refusal refusals) ])
