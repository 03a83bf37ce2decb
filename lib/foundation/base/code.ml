type t = string

let cannot_read = "SC0101"
let not_text = "SC0102"
let cannot_write = "SC0103"
let lexical = "SC0104"
let unterminated = "SC0105"
let number_too_large = "SC0106"
let zero_denominator = "SC0107"
let syntax = "SC0110"
let too_deep = "SC0111"
let empty_model = "SC0112"
let direction = "SC0113"
let unknown_name = "SC0201"
let duplicate_name = "SC0202"
let unknown_feature = "SC0203"
let bad_index = "SC0204"
let type_mismatch = "SC0205"
let bad_arity = "SC0206"
let division_by_zero = "SC0207"
let bad_value = "SC0208"
let unknown_parameter = "SC0209"
let wrong_kind = "SC0210"
let unused = "SC0211"
let repeated_attribute = "SC0212"
let no_effect = "SC0213"
let coarse_resolution = "SC0214"
let unstated_dynamics = "SC0215"
let import_cycle = "SC0216"
let bad_range = "SC0217"
let not_linear = "SC0218"
let no_solid = "SC0301"
let open_solid = "SC0302"
let overused_edge = "SC0303"
let bad_vertices = "SC0304"
let not_planar = "SC0305"
let not_convex_face = "SC0306"
let not_convex = "SC0307"
let coplanar_faces = "SC0308"
let inward_faces = "SC0309"
let several_solids = "SC0310"
let bad_transformation = "SC0311"
let off_centre = "SC0312"
let bad_mesh = "SC0320"
let mesh_format = "SC0321"
let cannot_snap = "SC0322"
let bad_picture = "SC0340"
let picture_format = "SC0341"
let picture_too_large = "SC0342"
let no_silhouette = "SC0343"
let several_pieces = "SC0344"
let cannot_inflate = "SC0345"
let flat_feature = "SC0336"
let crossing_faces = "SC0337"
let xml_malformed = "SC0350"
let xml_refused = "SC0351"
let xml_unexpected = "SC0352"
let xml_missing = "SC0353"
let xml_text = "SC0354"
let bad_region = "SC0360"
let off_surface = "SC0361"
let unknown_points = "SC0362"
let region_of_what = "SC0363"
let not_common = "SC0364"
let bad_curve = "SC0365"
let too_many_pieces = "SC0366"
let cut_shape = "SC0367"
let few_faces = "SC0370"
let outward_hollow = "SC0375"
let not_touching = "SC0401"
let not_highest = "SC0402"
let interpenetration = "SC0403"
let velocity_mismatch = "SC0404"
let not_connected = "SC0405"
let cyclic_bonds = "SC0406"
let fixed_motion = "SC0407"
let bare_feature = "SC0408"
let bad_absorber = "SC0409"
let unguarded = "SC0501"
let negative_delay = "SC0502"
let empty_channel = "SC0503"
let wrong_template = "SC0504"
let chance_at_any_time = "SC0505"
let bad_law = "SC0601"
let persistent_contact = "SC0602"
let bad_chance = "SC0603"
let not_a_formula = "SC0701"
let vacuous = "SC0702"
let uneventful = "SC0703"
let impossible_event = "SC0704"
let long_number = "SC0705"
let shared_edge = "SC0706"
let bad_schedule = "SC0801"
let schedule_mismatch = "SC0802"
let bad_graph = "SC0803"
let bad_trace = "SC0804"
let not_yet = "SC0901"
let any_time = "SC0902"
let not_known = "SC0903"
let no_store = "SC0910"
let other_store = "SC0911"
let damaged_store = "SC0912"
let no_state = "SC0920"
let lost_frame = "SC0921"
let not_asked = "SC0922"
let no_run = "SC0923"

let all =
  [
    (cannot_read, "a file cannot be read");
    (not_text, "a file is not UTF-8 text");
    (cannot_write, "an output cannot be written");
    (lexical, "a character or token that is not of the language");
    (unterminated, "a comment or string without its end");
    (number_too_large, "a number beyond the stated size limit");
    (zero_denominator, "a division by the literal zero");
    (syntax, "text that does not fit the grammar");
    (too_deep, "nesting or repetition beyond the stated limit");
    (empty_model, "a model that declares nothing");
    (direction, "a character that changes the direction in which a text is shown");
    (unknown_name, "a name that is not declared");
    (duplicate_name, "a name declared twice");
    (unknown_feature, "a feature that the shape does not have");
    (bad_index, "an index that is missing, not an integer or out of range");
    (type_mismatch, "an expression of the wrong type");
    (bad_arity, "a wrong number of arguments or components");
    (division_by_zero, "a division by zero in a constant expression");
    (bad_value, "a value out of its range (a mass that is not positive, a step that is zero)");
    (unknown_parameter, "an override of a parameter that the model does not have");
    (wrong_kind, "a name that stands for something else than is needed here");
    (unused, "a declaration that nothing uses");
    (repeated_attribute, "an attribute or setting given twice");
    (no_effect, "a setting that has no effect");
    (coarse_resolution, "a resolution that is coarse for the bodies");
    (unstated_dynamics, "a spin in a model that does not say its dynamics");
    (import_cycle, "an import that leads back to itself");
    (bad_range, "a range without numbers, or a value or range beyond the declared one");
    (not_linear, "a parameter with a range where its value must be known");
    (no_solid, "a set of faces that encloses no solid (E0)");
    (open_solid, "an edge that belongs to one face only (E2)");
    (overused_edge, "a directed edge that occurs in two faces (E1)");
    (bad_vertices, "vertices that coincide or that no face uses (E3)");
    (not_planar, "a face that is not planar (E4)");
    (not_convex_face, "a face that is not a simple, strictly convex polygon (E4)");
    (not_convex, "a vertex in front of a face plane (E5)");
    (coplanar_faces, "coplanar neighbouring faces (E5)");
    (inward_faces, "faces oriented inward (clockwise)");
    (several_solids, "faces of two or more separate solids");
    (bad_transformation, "an affine map that is singular or a reflection");
    (off_centre, "a template whose centroid is not the origin of body space (a warning)");
    (bad_mesh, "a mesh file that does not fit its format");
    (mesh_format, "a mesh format that is not supported");
    (cannot_snap, "a mesh for which no exact solid is found near by");
    (bad_picture, "a picture does not fit its format");
    (picture_format, "a picture's format, or something in it, is not supported");
    (picture_too_large, "a picture has too many pixels");
    (no_silhouette, "a picture in which nothing is drawn");
    (several_pieces, "a picture of several pieces, of which none or another one is chosen");
    (cannot_inflate, "a drawing that cannot be inflated as asked for");
    (flat_feature, "a vertex or an edge that is inside a face of a drawn solid");
    (crossing_faces, "faces of a drawn solid that cut or touch each other");
    (xml_malformed, "a text that is not well-formed XML");
    (xml_refused, "a document type, an entity or an encoding of XML that is not read");
    (xml_unexpected, "an element, attribute or text of XML that does not belong where it stands");
    (xml_missing, "an element or attribute of XML that is missing");
    (xml_text, "a text that XML cannot hold");
    (bad_region, "an expression that is no region of contact");
    (off_surface, "a region that is not on the surface of its shape");
    (unknown_points, "a region to be cut out of a shape whose points are not plain numbers");
    (region_of_what, "a region of which it is not known on which shape it is");
    (not_common, "a bond or glue that is not on the common surface of two regions");
    (bad_curve, "a curved solid without a polyhedron as near as it has to be");
    (too_many_pieces, "regions that cut a shape into too many pieces");
    (cut_shape, "a shape that its regions cut, where one in one piece is needed");
    (few_faces, "a solid around others that cannot have so few faces");
    (outward_hollow, "faces within a drawn solid that are turned outward, as those of a hollow are not");
    (not_touching, "features that do not touch");
    (not_highest, "a glue that is not the highest touching pair");
    (interpenetration, "bodies that interpenetrate");
    (velocity_mismatch, "parts of one body with different motions");
    (not_connected, "a compound whose glues do not join its parts into a tree");
    (cyclic_bonds, "bonds that close a cycle");
    (fixed_motion, "a fixed body that is given a motion or a mass");
    (bare_feature, "a bare feature name on a compound");
    (bad_absorber, "an absorbing body that moves, behaves or is bound");
    (unguarded, "a recursion that is not guarded");
    (negative_delay, "a negative delay");
    (empty_channel, "a channel or a strong split without entries");
    (wrong_template, "a behaviour used on another template than its own");
    (chance_at_any_time, "a chance of a split where bonds may be released at any time");
    (bad_law, "a law of motion that cannot be evaluated");
    (persistent_contact, "a contact of turning bodies at which time cannot pass");
    (bad_chance, "chances with which a bond is released that sum to more than 1");
    (not_a_formula, "a check that is not a temporal formula");
    (vacuous, "a check that says nothing, since its premise never holds");
    (uneventful, "a model in which no event ever happens");
    (impossible_event, "an event that no behaviour can bring about");
    (long_number, "a number that grows beyond the bound of bits");
    (shared_edge, "a bond on an edge or corner that several open faces share");
    (bad_schedule, "a schedule that does not fit its format or the model");
    (schedule_mismatch, "a choice that is not possible where it is made");
    (bad_graph, "a graph (.aut) that does not fit its format");
    (bad_trace, "a recorded trace that does not fit its format or the model");
    (not_yet, "a feature of the language that this version does not execute");
    (any_time, "weak splits at any time, where a grid of instants is looked at");
    (not_known, "parameters with ranges, where their values are needed");
    (no_store, "a folder is no store of explorations, or cannot be used as one now");
    (other_store, "a store keeps something else: of another model, with other options or of another version");
    (damaged_store, "a store is damaged");
    (no_state, "bytes that are no state of the model");
    (lost_frame, "a batch of states that does not fit its format");
    (not_asked, "a property or an exploration that the model does not have");
    (no_run, "a run that does not fit its format, or that the model does not have");
  ]
