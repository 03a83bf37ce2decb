(** The stable codes of diagnostics. A code, once released, keeps its meaning. *)

type t = private string

val all : (t * string) list
(** Every code with the fault that it stands for, in order. *)

(** {1 Reading files and text} *)

val cannot_read : t
(** SC0101: a file cannot be read. *)

val not_text : t
(** SC0102: a file is not UTF-8 text. *)

val cannot_write : t
(** SC0103: an output cannot be written. *)

val lexical : t
(** SC0104: a character or token that is not of the language. *)

val unterminated : t
(** SC0105: a comment or string without its end. *)

val number_too_large : t
(** SC0106: a number beyond the stated size limit. *)

val zero_denominator : t
(** SC0107: a division by the literal zero. *)

val syntax : t
(** SC0110: text that does not fit the grammar. *)

val too_deep : t
(** SC0111: nesting or repetition beyond the stated limit. *)

val empty_model : t
(** SC0112: a model that declares nothing. *)

val direction : t
(** SC0113: a character that changes the direction in which a text is shown (a warning): see {!Direction}. *)


(** {1 Names and values} *)

val unknown_name : t
(** SC0201: a name that is not declared. *)

val duplicate_name : t
(** SC0202: a name declared twice. *)

val unknown_feature : t
(** SC0203: a feature that the shape does not have. *)

val bad_index : t
(** SC0204: an index that is missing, not an integer or out of range. *)

val type_mismatch : t
(** SC0205: an expression of the wrong type. *)

val bad_arity : t
(** SC0206: a wrong number of arguments or components. *)

val division_by_zero : t
(** SC0207: a division by zero in a constant expression. *)

val bad_value : t
(** SC0208: a value out of its range (a mass that is not positive, a step that is zero). *)

val unknown_parameter : t
(** SC0209: an override of a parameter that the model does not have. *)

val wrong_kind : t
(** SC0210: a name whose kind is not the kind that is needed where it stands. *)

val unused : t
(** SC0211: a declaration that nothing uses. *)

val repeated_attribute : t
(** SC0212: an attribute or setting given twice. *)

val no_effect : t
(** SC0213: a setting that has no effect (a warning). *)

val coarse_resolution : t
(** SC0214: a resolution that is coarse for the bodies (a warning). *)

val unstated_dynamics : t
(** SC0215: a spin in a model that does not state its dynamics (a warning). *)

val import_cycle : t
(** SC0216: an import that leads back to itself. *)

val bad_range : t
(** SC0217: a range without numbers, or a value or range beyond the declared one. *)

val not_linear : t
(** SC0218: a parameter with a range where its value must be known. *)

(** {1 Templates (Definitions 4.1 to 4.4)} *)

val no_solid : t
(** SC0301: a set of faces that encloses no solid (E0). *)

val open_solid : t
(** SC0302: an edge that belongs to one face only (E2). *)

val overused_edge : t
(** SC0303: a directed edge that occurs in two faces (E1). *)

val bad_vertices : t
(** SC0304: vertices that coincide or that no face uses (E3). *)

val not_planar : t
(** SC0305: a face that is not planar (E4). *)

val not_convex_face : t
(** SC0306: a face that is not a simple, strictly convex polygon (E4). *)

val not_convex : t
(** SC0307: a vertex in front of a face plane (E5). *)

val coplanar_faces : t
(** SC0308: coplanar neighbouring faces (E5). *)

val inward_faces : t
(** SC0309: faces oriented inward (clockwise). *)

val several_solids : t
(** SC0310: faces of two or more separate solids. *)

val bad_transformation : t
(** SC0311: an affine map that is singular or a reflection. *)

val off_centre : t
(** SC0312: a template whose centroid is not the origin of body space (a warning). *)

val bad_mesh : t
(** SC0320: a mesh file that does not fit its format. *)

val mesh_format : t
(** SC0321: a mesh format that is not supported. *)

val cannot_snap : t
(** SC0322: a mesh without an exact solid near it. *)

val flat_feature : t
(** SC0336: a name of a vertex or an edge of a drawn solid that is inside one of its faces, or of a longer edge. *)

val crossing_faces : t
(** SC0337: two faces of a drawn solid that meet elsewhere than at edges and corners of both. *)

val bad_picture : t
(** SC0340: a picture that does not fit its format. *)

val picture_format : t
(** SC0341: a picture's format, or something in it, that is not supported. *)

val picture_too_large : t
(** SC0342: a picture of too many pixels. *)

val no_silhouette : t
(** SC0343: a picture in which nothing is drawn. *)

val several_pieces : t
(** SC0344: a picture of several pieces, of which none or another one is chosen. *)

val cannot_inflate : t
(** SC0345: a drawing that cannot be inflated with the given settings. *)

(** {1 Models in XML} *)

val xml_malformed : t
(** SC0350: a text that is not well-formed XML. *)

val xml_refused : t
(** SC0351: XML that is not read: a document type, an entity of its own, an encoding that is not UTF-8. *)

val xml_unexpected : t
(** SC0352: an element, attribute or text that does not belong where it stands. *)

val xml_missing : t
(** SC0353: an element or attribute that is missing. *)

val xml_text : t
(** SC0354: a text that XML cannot hold. *)

(** {1 Regions of the original notation} *)

val bad_region : t
(** SC0360: an expression that is no region of contact. *)

val off_surface : t
(** SC0361: a region that is not on the surface of its shape. *)

val unknown_points : t
(** SC0362: a region to be cut out of a shape whose points are not plain numbers. *)

val region_of_what : t
(** SC0363: a region whose shape is not known. *)

val not_common : t
(** SC0364: a bond or glue that is not on the common surface of two regions. *)

val bad_curve : t
(** SC0365: a curved solid without a polyhedron as near as it has to be. *)

val too_many_pieces : t
(** SC0366: regions that cut a shape into too many pieces. *)

val cut_shape : t
(** SC0367: a shape that its regions cut, where one in one piece is needed. *)

val few_faces : t
(** SC0370: a solid around others that cannot have so few faces. *)

val outward_hollow : t
(** SC0375: faces within a drawn solid that are turned outward, as those of a hollow are not. *)

(** {1 Compounds, bonds and networks (Definitions 4.5, 5.2; rule WellFormed)} *)

val not_touching : t
(** SC0401: features that do not touch. *)

val not_highest : t
(** SC0402: a glue that is not the highest touching pair. *)

val interpenetration : t
(** SC0403: bodies that interpenetrate. *)

val velocity_mismatch : t
(** SC0404: parts of one body with different motions. *)

val not_connected : t
(** SC0405: a compound whose glues do not join its parts into a tree. *)

val cyclic_bonds : t
(** SC0406: bonds that close a cycle. *)

val fixed_motion : t
(** SC0407: a fixed body that is given a motion or a mass. *)

val bare_feature : t
(** SC0408: a bare feature name on a compound. *)

val bad_absorber : t
(** SC0409: an absorbing body that moves, behaves or is bound. *)

(** {1 Behaviours (Definition 5.1)} *)

val unguarded : t
(** SC0501: a recursion that is not guarded. *)

val negative_delay : t
(** SC0502: a negative delay. *)

val empty_channel : t
(** SC0503: a channel or a strong split without entries. *)

val wrong_template : t
(** SC0504: a behaviour used on another template than its own. *)

val chance_at_any_time : t
(** SC0505: a chance of a split where bonds may be released at any time, so that there are no instants at which to
    draw. *)

(** {1 Motion} *)

val bad_law : t
(** SC0601: a law of motion that cannot be evaluated. *)

val persistent_contact : t
(** SC0602: two turning bodies that would interpenetrate at once though their response is zero. *)

val bad_chance : t
(** SC0603: chances with which a leaf releases a bond that sum to more than 1. *)


(** {1 Properties} *)

val not_a_formula : t
(** SC0701: a check that is not a temporal formula. *)

val vacuous : t
(** SC0702: a check that holds vacuously, since its premise never holds (a warning). *)

val uneventful : t
(** SC0703: a model in which no event ever happens (a warning). *)

val impossible_event : t
(** SC0704: an event that no behaviour can bring about (a warning). *)

val long_number : t
(** SC0705: a state that is not explored further, since one of its numbers is too long (a warning). *)

val shared_edge : t
(** SC0706: a bond made on an edge or a corner that several open faces of a body share (a warning). *)

(** {1 Schedules and traces} *)

val bad_schedule : t
(** SC0801: a schedule that does not fit its format or the model. *)

val schedule_mismatch : t
(** SC0802: a choice that is not possible where it is made. *)

val bad_graph : t
(** SC0803: a graph (.aut) that does not fit its format. *)

val bad_trace : t
(** SC0804: a recorded trace that does not fit its format or the model. *)


(** {1 Not yet} *)

val not_yet : t
(** SC0901: a feature of the language that this version does not execute. *)

val any_time : t
(** SC0902: weak splits at any time, where only a grid of instants is explored. *)

val not_known : t
(** SC0903: parameters with ranges, where their values are needed. *)

(** {1 Stores of explorations} *)

val no_store : t
(** SC0910: a folder that is no store of explorations, or cannot be used as one now. *)

val other_store : t
(** SC0911: a store that keeps something else: of another model, with other options or of another version. *)

val damaged_store : t
(** SC0912: a store that is damaged. *)

(** {1 Successors for programs} *)

val no_state : t
(** SC0920: bytes that are no state of the model. *)

val lost_frame : t
(** SC0921: a batch of states that does not fit its format. *)

val not_asked : t
(** SC0922: a property or an exploration that the model does not have. *)

val no_run : t
(** SC0923: a run that does not fit its format, or that the model does not have. *)
