"""The model of bodies: shapes by principal components, poses by a skeleton, and their atlases."""

from bodymeasure.fit.model.derivatives import pose_derivatives, shape_derivatives, turned
from bodymeasure.fit.model.limits import limit_matrix
from bodymeasure.fit.model.mapping import atlas_of_vertices, carried_landmarks, control_points_of
from bodymeasure.fit.model.posing import Bones, bones_of, posed, skinned, unposed, unskinned
from bodymeasure.fit.model.skeleton import Skeleton, skeleton
from bodymeasure.fit.model.space import BodyModel, body_model, coefficients_of, shaped

__all__ = [
    "BodyModel",
    "Bones",
    "Skeleton",
    "atlas_of_vertices",
    "body_model",
    "bones_of",
    "carried_landmarks",
    "coefficients_of",
    "control_points_of",
    "limit_matrix",
    "pose_derivatives",
    "posed",
    "shape_derivatives",
    "shaped",
    "skeleton",
    "skinned",
    "turned",
    "unposed",
    "unskinned",
]
